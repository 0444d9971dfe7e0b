#include "sinew/extend/frames.h"

#include "sinew/skeleton/frames.h"

namespace sinew {
Frame frame_along(const Vec3& z, double roll) {
    const Mat3 m = frame_about(z, roll);
    return {m.col(0), m.col(1), m.col(2)};
}

Frame turn_frame(const Frame& frame, const Vec3& to) {
    const Mat3 turn = Quat::FromTwoVectors(frame.z, to).toRotationMatrix();
    return {turn * frame.x, turn * frame.y, to};
}

}  // namespace sinew
