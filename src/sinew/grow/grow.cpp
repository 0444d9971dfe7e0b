#include "sinew/grow/grow.h"

#include <fmt/format.h>

#include <algorithm>

#include "sinew/grow/count.h"
#include "sinew/grow/derive.h"
#include "sinew/grow/parse.h"
#include "sinew/grow/program.h"
#include "sinew/grow/turtle.h"

namespace sinew {
namespace {

std::string shown(std::uint64_t count, const char* what) {
    return count == lsystem::countless ? fmt::format("more than {} {}", count, what)
                                       : fmt::format("{} {}", count, what);
}

/// What can be known before anything grows.
Result<std::int64_t> expected_nodes(const Grammar& grammar, lsystem::Program& program, std::int64_t limit,
                                    const Progress& progress) {
    const auto count = lsystem::count_nodes(grammar, program, progress);
    if (!count) return 0;
    const auto most = static_cast<std::uint64_t>(limit);
    if (count->nodes > most) return lsystem::too_many_nodes(grammar, shown(count->nodes, "nodes"), limit);
    if (count->modules / lsystem::work_per_node > most)
        return lsystem::too_much_work(grammar, shown(count->modules, "modules"), limit);
    return static_cast<std::int64_t>(count->nodes);
}

}  // namespace

Result<Grammar> parse_grammar(std::string_view text, std::string name) {
    auto grammar = lsystem::parse_statements(text, std::move(name));
    if (!grammar) return grammar;
    const auto program = lsystem::compile(*grammar);
    if (!program) return tl::unexpected(program.error());
    for (std::size_t i = 0; i < grammar->constants.size(); ++i)
        grammar->constants[i].value = program->constants[i];
    grammar->steps = program->steps;
    grammar->seed = program->seed;
    return grammar;
}

Result<Document> grow(const Grammar& grammar, const GrowOptions& options, const Progress& progress) {
    const std::int64_t limit = std::clamp<std::int64_t>(options.limit, 0, INT32_MAX / 8);
    auto program = lsystem::compile(grammar, options);
    if (!program) return tl::unexpected(program.error());
    const auto expected = expected_nodes(grammar, *program, limit, progress);
    if (!expected) return tl::unexpected(expected.error());

    lsystem::Turtle turtle(program->turtle, limit, *expected);
    const auto derived = program->context
                             ? lsystem::derive_in_context(grammar, *program, limit, turtle, progress)
                             : lsystem::derive_free(grammar, *program, limit, *expected, turtle, progress);
    if (!derived) return tl::unexpected(derived.error());
    if (turtle.node_count() > limit)
        return lsystem::too_many_nodes(grammar, lsystem::nodes_text(turtle.node_count()), limit);
    if (turtle.node_count() == 0)
        return fail(Error{.message = fmt::format("nothing is drawn after {} step{}", program->steps,
                                                 program->steps == 1 ? "" : "s"),
                          .cure = "the axiom or a production needs an F or a '.'",
                          .file = grammar.source.name()});
    Document document = turtle.finish();
    document.unit = grammar.unit;
    document.symmetry = grammar.symmetry;
    return document;
}

}  // namespace sinew
