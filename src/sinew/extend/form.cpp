#include "sinew/extend/form.h"

namespace sinew {

Vec3 stretched(const Form& form, const Vec3& direction, const Vec3& by) {
    return (direction.dot(form.x) * by.x() * form.x + direction.dot(form.y) * by.y() * form.y +
            direction.dot(form.z) * by.z() * form.z)
        .normalized();
}

double exit_of_ellipsoid(const Form& form, const Vec3& ray) { return 1 / form.local(ray).norm(); }

double exit_of_box(const Form& form, const Vec3& ray) { return 1 / form.local(ray).cwiseAbs().maxCoeff(); }

}  // namespace sinew
