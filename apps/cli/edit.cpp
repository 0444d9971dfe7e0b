#include "sinew/skeleton/edit.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include "cli/commands.h"
#include "cli/files.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/symmetry.h"

namespace sinew::cli {
namespace {

constexpr const char* help = R"(Operations, one after the other in the order given; IDs are those of nodes:
  consolidate[:DISTANCE[,SHARE]]  a node near each leaf, DISTANCE of its radii away (1), so that tips are blunter;
                                  its radius is the leaf's (SHARE 0) to its neighbour's (1, the default)
  merge:ID,ID                     two nodes, usually leaves, become one: bones merge or a cycle closes
  merge-close:DISTANCE            the same for all pairs of leaves so near, the closest first
  insert:ID[,SHARE]               a node on the bone from the node to its parent, SHARE of the way from there (0.5)
  dissolve:ID[,ID...]             nodes go, what they joined stays joined
  reroot:ID                       the node becomes the root of its tree
  mirror:AXIS                     the mirror image is added, in the plane through the origin; AXIS is x, y or z
  radial:AXIS,COUNT               images round an axis are added, COUNT in all
  expand                          the images of the document's symmetry become nodes
  grid:STEP                       positions become multiples of STEP
  angle:DEGREES                   directions of bones become multiples of DEGREES: 45, 30 ...

Examples:
  sinew edit fork.sinew -o blunt.sinew --op consolidate
  sinew edit arm.sinew -o arms.sinew --op grid:0.05 --op mirror:x
  sinew edit spoke.sinew -o wheel.sinew --op radial:z,12 --op merge-close:0.01)";

/// `name:argument,argument`, taken apart.
struct Operation {
    std::string text, name;
    std::vector<std::string> arguments;

    explicit Operation(const std::string& whole) : text(whole), name(whole.substr(0, whole.find(':'))) {
        if (name.size() == whole.size()) return;
        std::string rest = whole.substr(name.size() + 1);
        for (std::size_t comma; (comma = rest.find(',')) != std::string::npos; rest = rest.substr(comma + 1))
            arguments.push_back(rest.substr(0, comma));
        arguments.push_back(rest);
    }

    tl::unexpected<Error> wrong(const std::string& message) const {
        return fail(ErrorKind::call, fmt::format("--op {}: {}", text, message), "see 'sinew edit --help'");
    }
    template <class Number>
    Result<Number> number(std::size_t at, std::optional<Number> otherwise = {}) const {
        if (at >= arguments.size()) {
            if (otherwise) return *otherwise;
            return wrong("an argument is missing");
        }
        const std::string& word = arguments[at];
        Number value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            return wrong(fmt::format("'{}' is no number that fits", word));
        return value;
    }
    /// A length, which must be above 0 and finite.
    Result<double> length(std::size_t at, std::optional<double> otherwise = {}) const {
        Result<double> value = number<double>(at, otherwise);
        if (value && !(*value > 0 && *value <= 1e30)) return wrong("the number must be above 0 and finite");
        return value;
    }
    Result<int> axis(std::size_t at) const {
        const std::string word = at < arguments.size() ? arguments[at] : "";
        if (word.size() != 1 || word[0] < 'x' || word[0] > 'z') return wrong("the axis must be x, y or z");
        return word[0] - 'x';
    }
    Result<std::int32_t> node(const Document& document, std::size_t at) const {
        const Result<std::int64_t> id = number<std::int64_t>(at);
        if (!id) return fail(id.error());
        return node_with_id(document, *id);
    }
    Result<std::vector<std::int32_t>> nodes(const Document& document) const {
        std::vector<std::int32_t> found;
        for (std::size_t at = 0; at < std::max<std::size_t>(1, arguments.size()); ++at) {
            const Result<std::int32_t> one = node(document, at);
            if (!one) return fail(one.error());
            found.push_back(*one);
        }
        return found;
    }
};

Result<Document> consolidate(const Document& document, const Operation& operation) {
    const Result<double> distance = operation.length(0, 1.0), share = operation.number<double>(1, 1.0);
    if (!distance) return fail(distance.error());
    if (!share) return fail(share.error());
    if (!(*share >= 0 && *share <= 1)) return operation.wrong("the share must be from 0 to 1");
    return consolidate_leaves(document, {.distance = *distance, .radius_share = *share});
}

Result<Document> merge(const Document& document, const Operation& operation) {
    const auto nodes = operation.nodes(document);
    if (!nodes) return fail(nodes.error());
    if (nodes->size() != 2) return operation.wrong("two nodes are merged");
    return merge_nodes(document, std::vector<std::array<std::int32_t, 2>>{{(*nodes)[0], (*nodes)[1]}});
}

Result<Document> merge_close(const Document& document, const Operation& operation) {
    const Result<double> distance = operation.length(0);
    if (!distance) return fail(distance.error());
    return merge_nodes(document, close_leaves(document, *distance));
}

Result<Document> insert(const Document& document, const Operation& operation) {
    const Result<std::int32_t> node = operation.node(document, 0);
    if (!node) return fail(node.error());
    const Result<double> share = operation.number<double>(1, 0.5);
    if (!share) return fail(share.error());
    if (document.nodes[*node].parent < 0)
        return operation.wrong("the node is a root and has no bone to a parent");
    std::int32_t bone = 0;  // bones_of: those to the parents come first, in the order of the nodes
    for (std::int32_t i = 0; i < *node; ++i) bone += document.nodes[i].parent >= 0;
    return insert_on_bone(document, bone, 1 - *share);
}

Result<Document> dissolve_nodes(const Document& document, const Operation& operation) {
    const auto nodes = operation.nodes(document);
    if (!nodes) return fail(nodes.error());
    return dissolve(document, *nodes);
}

Result<Document> reroot_at(const Document& document, const Operation& operation) {
    const Result<std::int32_t> node = operation.node(document, 0);
    if (!node) return fail(node.error());
    return reroot(document, *node);
}

Result<Document> mirror_in(const Document& document, const Operation& operation) {
    const Result<int> axis = operation.axis(0);
    if (!axis) return fail(axis.error());
    return mirror(document, *axis);
}

Result<Document> radial(const Document& document, const Operation& operation) {
    const Result<int> axis = operation.axis(0), count = operation.number<int>(1);
    if (!axis) return fail(axis.error());
    if (!count) return fail(count.error());
    if (*count < 1 || *count > 1000) return operation.wrong("the count must be from 1 to 1000");
    return radial_copy(document, *axis, *count);
}

Result<Document> expand(const Document& document, const Operation&) {
    return expand_symmetry(document).document;
}

Result<Document> snap_grid(const Document& document, const Operation& operation) {
    const Result<double> step = operation.length(0);
    if (!step) return fail(step.error());
    return snap_to_grid(document, *step);
}

Result<Document> snap_angle(const Document& document, const Operation& operation) {
    const Result<double> degrees = operation.length(0);
    if (!degrees) return fail(degrees.error());
    return snap_to_angle(document, *degrees);
}

struct Known {
    std::string_view name;
    std::size_t most_arguments;
    Result<Document> (*work)(const Document&, const Operation&);
};
constexpr Known known[] = {{"consolidate", 2, consolidate},
                           {"merge", 2, merge},
                           {"merge-close", 1, merge_close},
                           {"insert", 2, insert},
                           {"dissolve", 1000000, dissolve_nodes},
                           {"reroot", 1, reroot_at},
                           {"mirror", 1, mirror_in},
                           {"radial", 2, radial},
                           {"expand", 0, expand},
                           {"grid", 1, snap_grid},
                           {"angle", 1, snap_angle}};

Result<Document> edited_by(const Document& document, const std::string& text) {
    const Operation operation(text);
    for (const Known& each : known) {
        if (each.name != operation.name) continue;
        if (operation.arguments.size() > each.most_arguments)
            return operation.wrong("there are too many arguments");
        return each.work(document, operation);
    }
    return operation.wrong("there is no such operation");
}

struct EditCommand {
    FileOptions files;
    std::vector<std::string> operations;

    Result<Outcome> work(Session& session, const Job& job) const {
        auto read = read_input_skeleton(session, job, files);
        if (!read) return fail(read.error());
        Document document = std::move(read->document);
        for (const std::string& operation : operations) {
            Result<Document> edited = edited_by(document, operation);
            if (!edited) return fail(edited.error());
            document = std::move(*edited);
        }
        if (const auto written = write_output_skeleton(session, document, job, files); !written)
            return fail(written.error());
        const std::size_t nodes = document.nodes.size(), bones = bones_of(document).size();
        return Outcome{.text = fmt::format("{}: {}, {}\n", job.output, counted(nodes, "node", "nodes"),
                                           counted(bones, "bone", "bones")),
                       .json = {{"nodes", nodes}, {"bones", bones}}};
    }
};

}  // namespace

void add_edit(CLI::App& program, Session& session) {
    auto command = std::make_shared<EditCommand>();
    CLI::App& app = add_command(program, command->files,
                                {.name = "edit",
                                 .about = "Change a skeleton by operations",
                                 .inputs = "Skeletons",
                                 .output = "The changed skeleton",
                                 .examples = help});
    app.add_option("--op", command->operations, "An operation, see below")
        ->required()
        ->type_name("OP")
        ->take_all()
        ->allow_extra_args(false);
    add_strict(app, session);
    work_on_each_input(app, session, command, ".sinew");
}

}  // namespace sinew::cli
