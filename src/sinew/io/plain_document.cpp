#include "sinew/io/plain_document.h"

#include <fmt/format.h>

#include <array>

#include "sinew/skeleton/symmetry.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

bool is_shaped(const Node& node) {
    return node.type != NodeType::sphere || node.section != Section::round || node.joint != 0 ||
           node.scale != std::array<double, 3>{1, 1, 1};
}

template <class Loses>
void warn_of_loss(PlainDocument& plain, std::string_view format, std::string_view what, Loses&& loses) {
    Warning warning{.count = 0};
    for (std::size_t i = 0; i < plain.document.nodes.size(); ++i) {
        if (!loses(i)) continue;
        ++warning.count;
        if (warning.nodes.size() < 16) warning.nodes.push_back(plain.document.nodes[i].id);
    }
    if (warning.count == 0) return;
    warning.message = fmt::format("{} node{} lost {}, which the format {} does not know", warning.count,
                                  warning.count == 1 ? "" : "s", what, format);
    plain.warnings.push_back(std::move(warning));
}

}  // namespace

Result<PlainDocument> plain_document(const Document& document, std::string_view format) {
    if (Result<void> valid = validate(document); !valid) return fail(std::move(valid.error()));
    PlainDocument plain{.document = expand_symmetry(document).document};
    const Document& all = plain.document;
    warn_of_loss(plain, format, "the type or shape", [&](std::size_t i) { return is_shaped(all.nodes[i]); });
    warn_of_loss(plain, format, "the name",
                 [&](std::size_t i) { return !all.names.empty() && !all.names[i].empty(); });
    return plain;
}

}  // namespace sinew
