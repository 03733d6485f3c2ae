# SPDX-License-Identifier: MIT
execute_process(COMMAND ${command} ${arguments} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE complained)
if(status EQUAL 0)
    message(FATAL_ERROR "it should have failed: ${arguments}")
endif()
string(FIND "${complained}" "${sentence}" found)
if(found EQUAL -1)
    message(FATAL_ERROR "stderr does not say '${sentence}' but: ${complained}")
endif()
