// SPDX-License-Identifier: MIT
#include "image/file_set.hpp"

#include "image/file.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace crease::tools;

TEST_CASE("file set: files appear together, over older ones, and those that go with the older ones go") {
    const temporary_folder folder;
    folder.put("a", "old a");
    folder.put("b", "old b");
    folder.put("mine", "kept");
    {
        file_set files(folder / "");
        write_atomically(files / "a", "new a");
        make_directory(files / "deep/er");
        write_atomically(files / "deep/er/c", "new c");
        CHECK(content_of(folder / "a") == "old a");
        const std::string older[] = {"a", "b"};
        files.appear(older);
    }
    CHECK(content_of(folder / "a") == "new a");
    CHECK(content_of(folder / "deep/er/c") == "new c");
    CHECK(content_of(folder / "mine") == "kept");
    CHECK(folder.files() == 3); // with the folder "deep"
}

TEST_CASE("file set: what does not appear leaves no trace") {
    const temporary_folder folder;
    folder.put("a", "old a");
    {
        const file_set files(folder / ""), others(folder / "new");
        write_atomically(files / "a", "new a");
        write_atomically(others / "a", "new a");
    }
    CHECK(content_of(folder / "a") == "old a");
    CHECK(folder.files() == 1);
}

TEST_CASE("file set: where one file cannot be replaced, all stay as they were") {
    const temporary_folder folder;
    folder.put("a", "old a");
    folder.put("c", "old c");
    std::filesystem::create_directory(folder / "b");
    {
        file_set files(folder / "");
        for (const char* name : {"a", "b"})
            write_atomically(files / name, "new");
        const std::string older[] = {"c"};
        expect_error<file_error>("b: not a regular file", [&] { files.appear(older); });
    }
    CHECK(content_of(folder / "a") == "old a");
    CHECK(content_of(folder / "c") == "old c");
    CHECK(folder.files() == 3);
    expect_error<file_error>("cannot make the directory", [&] { file_set(folder / "a"); });
}

TEST_CASE("file set: a signal waits until the files have appeared") {
    const temporary_folder folder;
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGINT, SIG_DFL);
        {
            file_set files(folder / "");
            write_atomically(files / "a", "new a");
            std::raise(SIGINT);
            files.appear();
        }
        _exit(0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(content_of(folder / "a") == "new a");
    CHECK(folder.files() == 1);
}
