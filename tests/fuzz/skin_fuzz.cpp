// Whatever a document says, skin() refuses it or makes what section 8 of the design promises of every
// accepted skeleton, and that can be subdivided. Bytes that begin with '{' are a file, others a drawn
// document.
#include <cstdint>
#include <span>

#include "drawn_document.h"
#include "round_trip.h"
#include "sinew/mesh/validate.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

namespace {

using namespace sinew;

Document document_of(std::span<const std::uint8_t> bytes) {
    if (bytes.empty() || bytes[0] != '{') return drawn_document(bytes);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const Result<ReadSkeleton> read = parse_skeleton(text, "a.sinew");
    return read ? read->document : Document{};
}

void check_mesh(const QuadMesh& mesh, std::int64_t components, std::int64_t cycles) {
    const Validation found = validate(mesh);
    must(found.finite(), "all coordinates are finite");
    must(found.closed(), "the mesh is closed");
    must(found.manifold() && !found.loose_vertices, "the mesh is a 2-manifold");
    must(found.oriented(), "all faces have one orientation");
    must(found.components == components, "one component a component");
    must(found.euler == 2 * components - 2 * cycles, "the Euler number is that of the skeleton");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Document document = document_of({data, size});
    const std::size_t images = document.symmetry.kind == Symmetry::Kind::none
                                   ? 1
                                   : static_cast<std::size_t>(std::max(document.symmetry.count, 2));
    if (document.nodes.empty() || document.nodes.size() > 1000 / images) return 0;
    const SkinOptions options{.fit = size % 2 == 0 ? Fit::control : Fit::limit, .repair = size % 3 == 0};
    const Result<Skin> made = skin(document, options);
    if (!made) {
        must(!made.error().message.empty() && made.error().kind != ErrorKind::program,
             "a refusal is the document's fault, and says what is wrong", made.error().text());
        return 0;
    }
    check_mesh(made->mesh, made->components, made->cycles);
    const Result<QuadMesh> finer = subdivide(made->mesh, {.levels = 1});
    must(finer.has_value(), "a skin can be subdivided", finer ? "" : finer.error().text());
    check_mesh(*finer, made->components, made->cycles);
    return 0;
}
