// SPDX-License-Identifier: MIT
#include "image/file.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <csignal>
#include <sys/resource.h>

using namespace crease::tools;

namespace {

/// While it lives, no file of this process can grow past a size: what a full disk looks like.
class disk_limit {
public:
    explicit disk_limit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limited);
    }
    disk_limit(const disk_limit&) = delete;
    disk_limit& operator=(const disk_limit&) = delete;
    ~disk_limit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, SIG_DFL);
    }

private:
    rlimit before_{};
};

}

TEST_CASE("file: what is written is read, over an older file and through a link") {
    const temporary_folder folder;
    const std::string content("a\0b\n\r", 5);
    write_atomically(folder / "target", "older and longer");
    std::filesystem::create_symlink(folder / "target", folder / "link");
    write_atomically(folder / "link", content);
    CHECK(read_file(folder / "target") == content);
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(folder.files() == 2);
}

TEST_CASE("file: a path without a folder is in the current one") {
    const temporary_folder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder / "");
    write_atomically("name", "x");
    std::filesystem::current_path(before);
    CHECK(content_of(folder / "name") == "x");
}

TEST_CASE("file: a full disk leaves what was there") {
    const temporary_folder folder;
    write_atomically(folder / "target", "old");
    {
        const disk_limit limit(1000);
        for (const unsigned size : {1001u, 100000u}) // fails when it is closed; when it is written
            expect_error<file_error>("is there room on the disk?",
                                     [&] { write_atomically(folder / "target", std::string(size, 'x')); });
    }
    CHECK(content_of(folder / "target") == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("file: what cannot be written") {
    const temporary_folder folder;
    expect_error<file_error>("cannot write in this directory: No such file or directory",
                             [&] { write_atomically(folder / "absent/name", "x"); });
    expect_error<file_error>("not a regular file", [&] { write_atomically(folder / "", "x"); });
    expect_error<file_error>("not a regular file", [] { write_atomically("/dev/null", "x"); });
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("file: what cannot be read") {
    const temporary_folder folder;
    expect_error<file_error>("absent: no such file", [&] { read_file(folder / "absent"); });
    expect_error<file_error>("not a regular file", [&] { read_file(folder / ""); });
    CHECK(read_file(folder.put("empty", "")).empty());
}
