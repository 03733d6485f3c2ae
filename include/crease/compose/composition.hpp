// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/described.hpp>
#include <crease/compose/recipe.hpp>

#include <cstddef>
#include <string_view>

namespace crease {

/// The effect of a recipe: the passes as data, in storage of its own.
///
/// The text of its passes is byte for byte that of the `effect` with the same parts. The object is large
/// (about 600 KB) and stays where it is made, as its passes view it.
class composition {
public:
    /// `from` must make an effect; otherwise, or where the passes do not fit each other, there are none.
    explicit composition(const recipe& from) {
        if (!from) {
            error_ << from.error();
            return;
        }
        const plan planned = make_plan(from.choices());
        refusal refused = planned.refused;
        resource_map map;
        pass_order order;
        for (std::size_t i = 0; i < planned.passes.size() && !refused; ++i) {
            write(planned, planned.passes[i]);
            const program& written = storage_[i].written;
            map.use(written);
            refused = order.next(planned, planned.passes[i], written);
        }
        if (refused) {
            error_ = refused.message();
            return;
        }
        map.number(planned);
        for (std::size_t i = 0; i < planned.passes.size(); ++i) {
            storage& own = storage_[i];
            for (std::size_t b = 0; b < own.written.bindings.size(); ++b)
                own.written.bindings[b].resource = map.index[own.written.bindings[b].resource];
            pass whole = describe(planned, planned.passes[i]);
            whole.pieces = {own.pieces, piece_count(own.written)};
            whole.bindings = own.written.bindings;
            whole.constants = own.written.constants;
            passes_.add(whole);
        }
        for (std::size_t i = 0; i < planned.resources.size(); ++i)
            if (map.is_used[i])
                resources_.add(describe(planned.resources[i]));
        settings_ = planned.settings;
        recipe_ = planned.recipe;
        views_ = planned.views;
        features_ = required_features(planned);
        defaults_ = default_parameters(settings_);
    }
    composition(const composition&) = delete;
    composition& operator=(const composition&) = delete;

    /// Whether there are passes.
    explicit operator bool() const { return error_.count == 0; }

    /// One sentence that says why not; empty where there are.
    std::string_view error() const { return error_.view(); }

    /// The effect as data, of which this holds the text and the lists.
    effect_view view() const& {
        return {passes_, resources_, settings_, views_, features_, defaults_, recipe_.view()};
    }
    /// The same, without a word: an effect is passed where its data is asked for.
    operator effect_view() const& { return view(); }
    effect_view view() const&& = delete; // it would view what is gone
    operator effect_view() const&& = delete;

private:
    struct storage {
        program written;
        char head[interface_text::most_characters];
        piece pieces[1 + 192 + 2];
    };

    void write(const plan& planned, const planned_pass& each) {
        storage& own = storage_[used_++];
        const file_list files = files_of(planned, each);
        const symbol_table* tables[file_list::capacity]{};
        for (std::size_t i = 0; i < files.size(); ++i)
            tables[i] = &table_of(files[i]);
        own.written = write_program(planned, each, {tables, files.size()}, files.cut);
        own.written.cut = own.written.cut || tables_.cut;
        own.written.head.write(own.head);
        list_pieces(own.written, own.head, own.pieces);
    }

    /// The symbols of a file, read once for all passes.
    const symbol_table& table_of(const glsl_file* file) {
        for (const symbol_table& known : tables_)
            if (known.file == file)
                return known;
        tables_.add(read_symbols(*file));
        return tables_[tables_.size() - 1];
    }

    fixed_list<symbol_table, 128> tables_;
    storage storage_[most_passes];
    std::size_t used_ = 0;
    fixed_list<pass, most_passes> passes_;
    fixed_list<resource, most_resources> resources_;
    fixed_list<effect_setting, most_settings> settings_;
    unsigned views_ = 1;
    device_features features_;
    parameters defaults_;
    fixed_text<512> recipe_;
    fixed_text<512> error_;
};

}
