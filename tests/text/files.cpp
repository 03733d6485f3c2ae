// SPDX-License-Identifier: MIT
// Each GLSL file compiles alone: with the prototypes of its contract, what is written for the program of an
// effect that has it, and the structs and constants of that effect, but no function of another part.
#include "pure/compositions.hpp"
#include "pure/glsl_files.hpp"
#include "text/host_program.hpp"

#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace crease;

std::string read(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The identifiers of a text that begin with `crease_`, comments aside.
std::set<std::string> identifiers_of(std::string_view text) {
    std::set<std::string> all;
    for_each_identifier(text, [&all](std::string_view word, std::string_view) { all.emplace(word); });
    return all;
}

/// The symbols of a file, read once.
const symbol_table& table_of(const glsl_file* file) {
    static std::map<const glsl_file*, std::unique_ptr<symbol_table>> known;
    std::unique_ptr<symbol_table>& table = known[file];
    if (!table)
        table = std::make_unique<symbol_table>(read_symbols(*file));
    return *table;
}

std::string_view text_of(const symbol_table& table, const definition& own) {
    return table.file->text.substr(own.begin, own.end - own.begin);
}

/// One GLSL file, and the program of a pass that may call it.
class file_alone {
public:
    file_alone(const glsl_file& file, const plan& p, const planned_pass& pass)
        : file_(file), pass_(pass), dialect_(p.dialect()),
          whole_(read(fs::path(CREASE_TEMPLATES) / file.name)) {
        const auto found = std::make_unique<linker>();
        for (const glsl_file* each : files_of(p, pass)) {
            files_.push_back(each);
            found->add(table_of(each));
        }
        for (const definition& each : table_of(&file).definitions)
            found->use(each.name);
        const auto written = std::make_unique<program>(program_writer(p, pass, *found).write());
        interface_.resize(written->head.size());
        written->head.write(interface_.data());
        if (interface_.find("#version") == std::string::npos)
            interface_ = "#version 450\n" + interface_;
        for (const std::string& name : identifiers_of(whole_))
            need(name);
        if (whole_.find("crease_write(") != std::string::npos) // which calls it
            before_ += "vec4 crease_encode_visibility(crease_result result);\n";
    }

    /// What the file names, and neither it, its contract nor what stands before it declares.
    std::vector<std::string> unknown() const {
        std::vector<std::string> names;
        const std::set<std::string> written = identifiers_of(interface_), before = identifiers_of(before_);
        for (const std::string& name : identifiers_of(whole_))
            if (!written.contains(name) && !before.contains(name) && !declares(name))
                names.push_back(name);
        return names;
    }

    /// What the file stands behind.
    std::string before() const { return interface_ + before_; }

    /// @throws spirv::error  where it does not compile
    void compile() const {
        const bool has_main = whole_.find("void main()") != std::string::npos;
        const piece pieces[] = {{"interface", interface_},
                                {"before", before_},
                                {file_.name, whole_},
                                {"end", has_main ? "" : "void main() {}\n"}};
        const spirv::shader_stage stage =
            pass_.stage == stage_kind::geometry || pass_.stage == stage_kind::fragment
                ? spirv::shader_stage::fragment
                : spirv::shader_stage::compute;
        spirv::detail::parse(pieces, stage, dialect_, file_.name);
    }

private:
    /// Adds a struct, constant or variable of another file after what it needs itself; and of the camera and
    /// its texels, which no file has to state that it calls, functions too.
    void need(const std::string& name) {
        if (!known_.insert(name).second || declares(name))
            return;
        for (const glsl_file* each : files_)
            for (const definition& own : table_of(each).definitions) {
                if (own.name != symbol_of(name) || each == &file_)
                    continue;
                const std::string_view text = text_of(table_of(each), own);
                if (is_function(text) && each != &view_glsl && each != &texels_glsl)
                    return;
                for (const std::string& needed : identifiers_of(text))
                    need(needed);
                before_ += text;
                return;
            }
    }

    /// Whether the file or its contract declares a name: as a word after another word, before what follows a
    /// name.
    bool declares(const std::string& name) const {
        for (std::size_t at = whole_.find(name); at != std::string::npos; at = whole_.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            const bool is_whole = !reading::is_word(whole_[end]) && !reading::is_word(whole_[at - 1]);
            const std::size_t line = whole_.rfind('\n', at) + 1;
            const bool at_top =
                line != at && whole_[line] != ' ' && whole_[line] != '/' && whole_[line] != '#';
            if (is_whole && at_top && whole_[at - 1] == ' ' &&
                std::string_view("({ [;").find(whole_[end]) != std::string_view::npos &&
                whole_.find_first_of("(=", line) >= at)
                return true;
        }
        return false;
    }

    const glsl_file& file_;
    const planned_pass& pass_;
    dialect_kind dialect_;
    std::string whole_, interface_, before_;
    std::vector<const glsl_file*> files_;
    std::set<std::string> known_;
};

}

TEST_CASE("each GLSL file alone") {
    std::set<const glsl_file*> left = all_glsl_files();
    left.erase(&fullscreen_glsl);                    // a program by itself, compiled with every fragment pass
    left.erase(&glsl_es_300_glsl);                   // likewise, with every one in GLSL ES 3.00
    std::map<const glsl_file*, std::string> missing; // why the last try is none
    std::set<std::string> tried;
    std::size_t compiled = 0;
    for (const std::string& text : every_recipe()) {
        if (left.empty())
            break;
        const auto p = std::make_unique<plan>(make_plan(recipe(std::string_view(text)).choices()));
        if (p->dialect() == dialect_kind::opengl || p->dialect() == dialect_kind::webgpu)
            continue;
        for (const planned_pass& pass : p->passes)
            for (const glsl_file* file : files_of(*p, pass)) {
                if (!left.contains(file))
                    continue;
                const file_alone alone(*file, *p, pass);
                if (!tried.insert(std::string(file->name) + without_recipe(alone.before())).second)
                    continue;
                // Not all of a file is for every effect that has it: some is for bent cones, some for a step
                // alone.
                try {
                    std::string names;
                    for (const std::string& each : alone.unknown())
                        names += " " + each;
                    if (!names.empty())
                        throw spirv::error("nothing declares" + names);
                    alone.compile();
                    left.erase(file);
                    ++compiled;
                } catch (const spirv::error& refused) {
                    missing[file] = text + ": " + refused.what();
                }
            }
    }
    for (const glsl_file* file : left)
        FAIL_CHECK(std::string(file->name) << " compiles alone in no effect: " << missing[file]);
    CHECK(compiled > 100);
}

TEST_CASE("each GLSL file belongs to a part or to the core") {
    std::set<std::string> known;
    for (const glsl_file* file : all_glsl_files())
        known.emplace(file->name);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(CREASE_TEMPLATES))
        if (entry.path().extension() == ".glsl") {
            const std::string name = fs::relative(entry.path(), CREASE_TEMPLATES).generic_string();
            CAPTURE(name);
            CHECK(known.erase(name) == 1);
        }
    CHECK(known.empty());
}

TEST_CASE("an error names the file and its line") {
    const std::string wrong =
        read(fs::path(CREASE_TEMPLATES) / "noise/hashed_noise.glsl") + "float broken = nothing;\n";
    const piece pieces[] = {{"interface", "#version 450\nconst uint crease_frame = 0u;\n"},
                            {"noise/hashed_noise.glsl", wrong},
                            {"end", "void main() {}\n"}};
    const long line = std::count(wrong.begin(), wrong.end(), '\n');
    CHECK_THROWS_WITH_AS(spirv::compile(pieces, spirv::shader_stage::compute),
                         doctest::Contains(("noise/hashed_noise.glsl:" + std::to_string(line)).c_str()),
                         spirv::error);
}
