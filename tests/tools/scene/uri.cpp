// SPDX-License-Identifier: MIT
#include "scene/uri.hpp"

#include "expect_error.hpp"
#include "scene/scene.hpp"

using namespace crease::tools;

TEST_CASE("URIs: percent-encoded bytes") {
    CHECK(percent_decoded("my%20box%C3%bc+.bin") == "my box\xc3\xbc+.bin");
    CHECK(percent_decoded("").empty());
    for (const std::string broken : {"%", "a%2", "%2g", "%-1", "% 1"})
        expect_error<scene_error>("a URI has a % without two hexadecimal digits",
                                  [&] { percent_decoded(broken); });
}

TEST_CASE("URIs: base64, as RFC 4648 gives it") {
    const std::pair<std::string, std::string> cases[] = {{"", ""},
                                                         {"Zg==", "f"},
                                                         {"Zm8=", "fo"},
                                                         {"Zm9v", "foo"},
                                                         {"Zm9vYg==", "foob"},
                                                         {"Zm9vYmE=", "fooba"},
                                                         {"Zm9vYmFy", "foobar"},
                                                         {"Zm9vYg", "foob"},
                                                         {"+/+/", "\xfb\xff\xbf"}};
    for (const auto& [text, bytes] : cases)
        CHECK(base64_decoded(text) == bytes);
    for (const std::string broken : {"Zm9v Yg==", "Zg==Zg==", "Zm-v", "Zm\xff"})
        expect_error<scene_error>("a data URI is not base64", [&] { base64_decoded(broken); });
}
