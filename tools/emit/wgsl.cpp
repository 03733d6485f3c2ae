// SPDX-License-Identifier: MIT
#include "wgsl.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

namespace crease::tools {

namespace {

namespace fs = std::filesystem;

// Each N.spv of the folder to N.wgsl; what is wrong to error.txt.
constexpr const char* script = R"js(
const {createRequire} = require('node:module');
const {existsSync, readFileSync, writeFileSync} = require('node:fs');
const {pathToFileURL} = require('node:url');
const folder = process.argv[2];

async function translate() {
    const {translate} = await import(pathToFileURL(createRequire(process.cwd() + '/').resolve('naga-wasm')));
    for (let i = 0; existsSync(`${folder}/${i}.spv`); ++i) {
        const source = new Uint32Array(Uint8Array.from(readFileSync(`${folder}/${i}.spv`)).buffer);
        writeFileSync(`${folder}/${i}.wgsl`, translate({from: 'spirv', source, to: 'wgsl'}));
    }
}
translate().catch((error) => {
    writeFileSync(`${folder}/error.txt`, error.code === 'MODULE_NOT_FOUND' ? '' : String(error.formatted ?? error));
    process.exit(1);
});
)js";

constexpr const char* what_is_needed =
    "WGSL needs node, and naga-wasm where node looks for packages from here: npm install naga-wasm@30.1.0";

/// A folder that goes with the object.
struct scratch_folder {
    fs::path path = fs::temp_directory_path() / ("crease-wgsl-" + std::to_string(std::random_device()()));
    scratch_folder() { fs::create_directory(path); }
    ~scratch_folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    scratch_folder(const scratch_folder&) = delete;
    scratch_folder& operator=(const scratch_folder&) = delete;
};

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const char* bytes, std::size_t count) {
    std::ofstream file(path, std::ios::binary);
    if (!file.write(bytes, static_cast<std::streamsize>(count)))
        throw std::runtime_error(path.string() + " cannot be written");
}

}

std::vector<std::string> wgsl_of(const std::vector<const spirv::words*>& modules) {
    if (modules.empty())
        return {};
    const scratch_folder scratch;
    for (std::size_t i = 0; i < modules.size(); ++i)
        write(scratch.path / (std::to_string(i) + ".spv"), reinterpret_cast<const char*>(modules[i]->data()),
              4 * modules[i]->size());
    const fs::path program = scratch.path / "translate.cjs";
    write(program, script, std::char_traits<char>::length(script));
    const std::string log = (scratch.path / "log.txt").string();
    const std::string command =
        "node \"" + program.string() + "\" \"" + scratch.path.string() + "\" > \"" + log + "\" 2>&1";
    if (std::system(command.c_str()) != 0) {
        const std::string reason = read(scratch.path / "error.txt");
        throw std::runtime_error(reason.empty() ? what_is_needed : "naga refuses a pass: " + reason);
    }
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < modules.size(); ++i)
        texts.push_back(read(scratch.path / (std::to_string(i) + ".wgsl")));
    return texts;
}

}
