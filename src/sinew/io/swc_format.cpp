#include "sinew/io/swc_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "sinew/io/field_reader.h"
#include "sinew/io/json_text.h"
#include "sinew/io/plain_document.h"
#include "sinew/io/swc_soma.h"
#include "sinew/skeleton/graph.h"

namespace sinew {
namespace {

tl::unexpected<Error> fail_at(const SwcSample& sample, std::string message, std::string cure) {
    return fail(Error{
        .message = std::move(message), .cure = std::move(cure), .line = sample.line, .node = sample.id});
}

Result<SwcSample> read_sample(FieldReader& fields) {
    SwcSample sample{.line = fields.line()};
    // A lambda for each field would be no shorter than this: the first error ends the line.
    Result<std::int64_t> id = fields.integer("id");
    if (!id) return fail(std::move(id.error()));
    if (*id < 0)
        return fields.fail_here(fmt::format("the id {} is negative", *id), "number the samples from 1 up");
    Result<std::int64_t> type = fields.integer("type");
    if (!type) return fail(std::move(type.error()));
    for (int axis = 0; axis < 3; ++axis) {
        Result<double> coordinate = fields.number(std::string_view("xyz").substr(axis, 1));
        if (!coordinate) return fail(std::move(coordinate.error()));
        sample.position[axis] = *coordinate;
    }
    Result<double> radius = fields.number("radius");
    if (!radius) return fail(std::move(radius.error()));
    Result<std::int64_t> parent = fields.integer("parent");
    if (!parent) return fail(std::move(parent.error()));
    if (*parent < -1)
        return fields.fail_here(fmt::format("the parent {} is negative", *parent), "write -1 for a root");
    sample.id = *id;
    sample.type = *type;
    sample.radius = *radius;
    sample.parent_id = *parent;
    return sample;
}

Result<std::vector<SwcSample>> read_samples(std::string_view text) {
    std::vector<SwcSample> samples;
    FieldReader fields(text);
    while (fields.next_line()) {
        Result<SwcSample> sample = read_sample(fields);
        if (!sample) return fail(std::move(sample.error()));
        samples.push_back(*sample);
    }
    if (samples.empty())
        return fail(ErrorKind::input, "the file has no samples",
                    "write id type x y z radius parent for each");
    return samples;
}

Result<void> find_parents(std::vector<SwcSample>& samples) {
    std::vector<std::pair<std::int64_t, std::int32_t>> by_id;
    by_id.reserve(samples.size());
    for (std::int32_t i = 0; i < std::ssize(samples); ++i) by_id.emplace_back(samples[i].id, i);
    if (!std::ranges::is_sorted(by_id)) std::ranges::sort(by_id);
    for (std::size_t k = 1; k < by_id.size(); ++k)
        if (by_id[k].first == by_id[k - 1].first)
            return fail_at(
                samples[by_id[k].second],
                fmt::format("the id is used twice, first on line {}", samples[by_id[k - 1].second].line),
                "give every sample an id of its own");
    for (SwcSample& sample : samples) {
        if (sample.parent_id == -1) continue;
        if (sample.parent_id == sample.id)
            return fail_at(sample, "the sample is its own parent", "write -1 for a root");
        const auto found = std::ranges::lower_bound(by_id, std::pair(sample.parent_id, std::int32_t{0}));
        if (found == by_id.end() || found->first != sample.parent_id)
            return fail_at(sample, fmt::format("the parent {} does not exist", sample.parent_id),
                           "name an existing sample, or -1 for a root");
        sample.parent = found->second;
    }
    return {};
}

Result<void> check_cycles(const std::vector<SwcSample>& samples) {
    std::vector<std::int32_t> walk(samples.size(), -1);
    for (std::int32_t start = 0; start < std::ssize(samples); ++start) {
        std::int32_t i = start;
        for (; i >= 0 && walk[i] < 0; i = samples[i].parent) walk[i] = start;
        if (i >= 0 && walk[i] == start)
            return fail_at(
                samples[i],
                fmt::format("the sample is its own ancestor, by way of its parent {}", samples[i].parent_id),
                "give one sample of the cycle another parent, or -1");
    }
    return {};
}

/// The node of each sample that is left; nodes keep the order of the file.
ReadSkeleton to_skeleton(const std::vector<SwcSample>& samples, const std::vector<char>& gone,
                         std::vector<std::int64_t>& lines) {
    ReadSkeleton read{.measured = true};
    read.document.unit = "um";
    std::vector<std::int32_t> node_of(samples.size(), -1);
    for (std::size_t i = 0, next = 0; i < samples.size(); ++i)
        if (!gone[i]) node_of[i] = static_cast<std::int32_t>(next++);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (gone[i]) continue;
        const SwcSample& sample = samples[i];
        read.document.nodes.push_back({.id = sample.id,
                                       .parent = sample.parent < 0 ? -1 : node_of[sample.parent],
                                       .position = sample.position,
                                       .radius = sample.radius});
        read.document.extras.push_back(fmt::format("{{\"swc_type\":{}}}", sample.type));
        lines.push_back(sample.line);
    }
    return read;
}

// --- writing

/// Nodes, parents before children, as near to their own order as that allows.
std::vector<std::int32_t> parents_first(const Document& document) {
    std::vector<std::int32_t> order, way;
    std::vector<char> done(document.nodes.size(), 0);
    order.reserve(document.nodes.size());
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        for (std::int32_t k = i; k >= 0 && !done[k]; k = document.nodes[k].parent) {
            way.push_back(k);
            done[k] = 1;
        }
        order.insert(order.end(), way.rbegin(), way.rend());
        way.clear();
    }
    return order;
}

bool ids_suit(const Document& document) {
    return std::ranges::all_of(document.nodes, [&](const Node& node) {
        return node.id > 0 && (node.parent < 0 || document.nodes[node.parent].id < node.id);
    });
}

std::int64_t type_of(const Document& document, std::int32_t node) {
    if (document.extras.empty() || document.extras[node].empty()) return 0;
    const Result<Json> keys = parse_json(document.extras[node]);
    const Json* type = keys && keys->is_object() ? find(*keys, "swc_type") : nullptr;
    return type ? integer_in(*type).value_or(0) : 0;
}

}  // namespace

Result<ReadSkeleton> parse_swc(std::string_view text, const ReadOptions& options) try {
    Result<std::vector<SwcSample>> samples = read_samples(text);
    if (!samples) return fail(std::move(samples.error()));
    if (Result<void> found = find_parents(*samples); !found) return fail(std::move(found.error()));
    if (Result<void> sound = check_cycles(*samples); !sound) return fail(std::move(sound.error()));
    Remarks remarks;
    const std::vector<char> gone = fold_somata(*samples, remarks);
    std::vector<std::int64_t> lines;
    ReadSkeleton read = to_skeleton(*samples, gone, lines);
    repair_radii(read.document, lines, remarks);
    note_zero_lengths(read.document, lines, remarks);
    Result<Warnings> warnings = remarks.take(options.strict);
    if (!warnings) return fail(std::move(warnings.error()));
    read.warnings = std::move(*warnings);
    return read;
} catch (const std::exception& exception) {  // bad_alloc
    return fail(ErrorKind::program, fmt::format("the morphology cannot be taken in ({})", exception.what()));
}

Result<WrittenSkeleton> print_swc(const Document& given) {
    Result<PlainDocument> plain = plain_document(given, "swc");
    if (!plain) return fail(std::move(plain.error()));
    const Document& document = plain->document;
    if (!document.links.empty())
        plain->warnings.push_back(
            {.message = fmt::format("{} link{} lost: the format swc knows trees only", document.links.size(),
                                    document.links.size() == 1 ? " was" : "s were"),
             .count = std::ssize(document.links)});
    const std::vector<std::int32_t> order = parents_first(document);
    const bool keep_ids = ids_suit(document);
    if (!keep_ids)
        plain->warnings.push_back({.message = "the nodes were numbered anew, from 1, parents first"});
    std::vector<std::int64_t> number(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        number[order[k]] = keep_ids ? document.nodes[order[k]].id : static_cast<std::int64_t>(k) + 1;

    std::string text = "# id type x y z radius parent\n";
    for (std::int32_t i : order) {
        const Node& node = document.nodes[i];
        fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {}\n", number[i], type_of(document, i),
                       node.position.x(), node.position.y(), node.position.z(), node.radius,
                       node.parent < 0 ? -1 : number[node.parent]);
    }
    return WrittenSkeleton{std::move(text), std::move(plain->warnings)};
}

}  // namespace sinew
