/// @file smooth_skin.h
/// Skeleton in, smooth surface out: skin, fit and subdivide as one call.
#pragma once

#include <cstdint>
#include <optional>

#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

namespace sinew {

struct SmoothSkinOptions {
    int levels = 0;  ///< of subdivision; 0: the control mesh
    /// What the radii of the skeleton are those of. Unless told: of what is made, which is the limit where it
    /// is subdivided and the control mesh where it is not.
    std::optional<Fit> fit;
    int sides = 0;  ///< as in SkinOptions, like those that follow
    bool repair = false;
    SkinStage stage = SkinStage::place;
    std::optional<double> blend;
    std::optional<Density> density;
    std::uint64_t memory = 0;  ///< as in SubdivideOptions
};

struct SmoothSkin {
    Skin skin;  ///< its mesh is the subdivided one; all else is as the control mesh has it
    double skin_seconds = 0;
    double subdivide_seconds = 0;
};

/// Skins a document and subdivides the mesh. Fitted to the limit, the vertices of a subdivided mesh lie on the
/// limit surface, so that it has the radii at any level. Fails as skin() and subdivide() do. Of the progress,
/// the first half is that of skin() where both have work to do.
Result<SmoothSkin> smooth_skin(const Document& document, const SmoothSkinOptions& options = {},
                               const Progress& progress = {});

/// The same for a skeleton that changes and is skinned again and again: remembers the tables of the last
/// topology, since most changes move vertices only. Makes the bytes that smooth_skin() makes. Not for two
/// threads at once.
class SmoothSkinner {
  public:
    Result<SmoothSkin> operator()(const Document& document, const SmoothSkinOptions& options = {},
                                  const Progress& progress = {});

  private:
    Result<const QuadMesh*> refine(const QuadMesh& control, const SubdivideOptions& options,
                                   const Progress& progress);

    QuadMesh control_;  ///< the last one, whose tables these are
    SubdivideOptions options_;
    std::optional<Subdivider> subdivider_;
};

}  // namespace sinew
