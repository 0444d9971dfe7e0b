#include "sinew/extend/box_faces.h"

#include "building.h"

namespace sinew {
namespace {

using namespace testing_types;

Form turned_box() {
    const Mat3 axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    Form box;
    box.kind = Form::Kind::box;
    box.x = axes.col(0), box.y = axes.col(1), box.z = axes.col(2);
    box.half = {1, 2, 5};
    return box;
}

TEST(BoxFaces, AreFlatPartsOfTheBoxThatLookOutward) {
    const Form box = turned_box();
    const Vec3 centre(3, -1, 2);
    for (int i = 0; i < face_count; ++i) {
        const Face face = face_of(box, centre, i);
        EXPECT_LT(distance(face.frame.x.cross(face.frame.y), face.frame.z), 1e-12);
        EXPECT_GT(face.frame.z.dot(face.middle - centre), 0);
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) {
                const Vec3 corner =
                    face.middle + x * face.half_x * face.frame.x + y * face.half_y * face.frame.y;
                EXPECT_LT(distance(box.local(corner - centre).cwiseAbs(), {1, 1, 1}), 1e-12) << i;
            }
    }
}

TEST(BoxFaces, AheadAndBehindAreThoseOfZ) {
    const Form box = turned_box();
    EXPECT_LT(distance(face_of(box, {0, 0, 0}, face_ahead).middle, 5 * box.z), 1e-12);
    EXPECT_LT(distance(face_of(box, {0, 0, 0}, face_behind).middle, -5 * box.z), 1e-12);
}

TEST(BoxFaces, AWayOutLeavesThroughTheFaceItPointsAt) {
    const Form box = turned_box();
    for (int i = 0; i < face_count; ++i) {
        const Face face = face_of(box, {0, 0, 0}, i);
        for (const double x : {-0.9, 0.0, 0.9})
            for (const double y : {-0.9, 0.0, 0.9}) {
                const Vec3 on_face =
                    face.middle + x * face.half_x * face.frame.x + y * face.half_y * face.frame.y;
                EXPECT_EQ(face_towards(box, 0.1 * on_face), i);
                EXPECT_EQ(face_towards(box, 10 * on_face), i);
            }
    }
}

TEST(BoxFaces, SizesAreFullExtentsAndElseTheRadius) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.7, NodeType::cube);
    add(d, -1, {5, 0, 0}, 0.7, NodeType::cube).size = Vec3(1, 2, 3);
    const Built b(d);
    EXPECT_EQ(half_size(b.builder, 0), Vec3(0.7, 0.7, 0.7));
    EXPECT_EQ(half_size(b.builder, 1), Vec3(0.5, 1, 1.5));
}

TEST(BoxFaces, JointsAreRootsBranchesAndWhatIsHollowed) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5, NodeType::cube);
    add(d, 0, {0, 0, 2}, 0.5, NodeType::cube);   // on a path
    add(d, 1, {0, 0, 4}, 0.5, NodeType::cube);   // a branch
    add(d, 2, {0, 2, 6}, 0.5, NodeType::cube);   // an end
    add(d, 2, {0, -2, 6}, 0.5, NodeType::cube);  // hollowed
    add(d, 4, {0, -3, 6}, 0.2, NodeType::negative);
    const Built b(d);
    const bool expected[] = {true, false, true, false, true};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(is_box_joint(b.builder, i), expected[i]) << i;
}

}  // namespace
}  // namespace sinew
