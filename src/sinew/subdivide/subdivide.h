/// @file subdivide.h
/// The smooth surface that a control mesh stands for, as a finer mesh.
///
/// Catmull-Clark on polygon meshes, open ones too (E. Catmull, J. Clark, "Recursively generated B-spline
/// surfaces on arbitrary topological meshes", 1978), with semi-sharp creases (DeRose and others 1998:
/// sharpness.h), C2 poles (Myles and Peters 2009: fans.h), circles, cones and discs (rounds.h) and planes
/// (flats.h). Without poles, circles and planes it is what OpenSubdiv makes with
/// VTX_BOUNDARY_EDGE_AND_CORNER. docs/subdivision.md explains.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sinew/base/progress.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

struct SubdivideOptions {
    int levels = 1;      ///< 0 and up: each makes about four faces of one
    bool limit = false;  ///< put the vertices of the finest level where they go without end
    bool detect_poles =
        false;  ///< for meshes from files: take detect_poles (fans.h) where the mesh lists no poles
    std::uint64_t memory = 0;  ///< bytes it may take beside the control mesh; 0: what the machine has left
};

/// Subdivides a mesh. The vertices of the control mesh come first and keep their numbers; the parts of a face
/// follow each other. All is quads but the triangles at poles. Features, and where the vertices came from,
/// are carried along: creases lose 1 of their sharpness a level, planes and circles stay, a new vertex takes
/// node and bone of the first of the vertices that it lies between and the mean parameter of those on the
/// same bone.
///
/// Fails for a mesh that check_control_mesh refuses and for features that name what the mesh has not
/// (ErrorKind::input), for negative levels and for a level that has more faces than a mesh or the memory can
/// hold, which the message tells, before anything of it is made (ErrorKind::call), and when it is stopped.
/// Linear in what it makes; takes at most 2.5 times the memory of the finest mesh, that mesh included. The
/// same bytes on any number of threads.
Result<QuadMesh> subdivide(const QuadMesh& mesh, const SubdivideOptions& options = {},
                           const Progress& progress = {});

/// Subdivides one topology for many positions: the tables are built once.
class Subdivider {
  public:
    /// Builds the tables and refines the positions of `mesh`. Fails as `subdivide` does.
    static Result<Subdivider> build(const QuadMesh& mesh, const SubdivideOptions& options = {},
                                    const Progress& progress = {});
    Subdivider(Subdivider&&) noexcept;
    Subdivider& operator=(Subdivider&&) noexcept;
    ~Subdivider();

    /// The finest mesh, with the positions of the last refine.
    const QuadMesh& mesh() const;

    /// Refines other positions of the control mesh; circles and planes stay where they were. Nothing is
    /// allocated but for circles and poles. Fails (ErrorKind::call), leaving all as it was, for another
    /// number of vertices.
    Result<void> refine(std::span<const Vec3f> control);
    /// The same, and moves circles and planes (their number must be the same) to where `control` has them,
    /// and takes over where its vertices came from.
    Result<void> refine(const QuadMesh& control);

    /// Unit normals of the limit surface, outward, one for each corner of mesh(), so that creases stay sharp.
    /// Where there is no tangent plane (the tip of a cone) each face has its own. Several threads may ask at
    /// once, for this and for mesh().
    std::vector<Vec3f> limit_normals() const;

    /// Gives the mesh away and ends the use of this object.
    QuadMesh take() &&;

  private:
    friend class TableBuilder;
    struct Tables;
    explicit Subdivider(std::unique_ptr<Tables> tables);
    std::unique_ptr<Tables> tables_;
};

}  // namespace sinew
