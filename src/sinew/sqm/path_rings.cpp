#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/extend/frames.h"
#include "sinew/sqm/path_work.h"

namespace sinew::sqm {
namespace {

constexpr double steep = 0.45;  // sine of a cone's slope from which its round parts get rings of their own
constexpr double very_steep = 0.85;
constexpr double corner = 0.1;    // radians between two slopes from which their ring needs others beside it
constexpr double straight = 0.6;  // cosine of the bend from which its arms are held straight
constexpr float pit_rings[] = {1.0f, 0.8f, 0.45f};  // widths of the rings down a dent

class RingPlacer {
  public:
    RingPlacer(PathWork& work, bool keep_all) : w_(work), kept_(work.kept), heights_(work.heights) {
        kept_.assign(w_.count(), 1);
        if (!w_.s.forms.empty() && !w_.closed) find_bores();
        if (!keep_all && !w_.closed) leave_out_nodes();
    }

    void run() {
        w_.rings.clear();
        if (!w_.closed && !w_.near.any()) add_end(false);
        for (std::int32_t i = 0; i < w_.count(); ++i) {
            if (w_.is_inner(i) && kept_[i]) add_at_node(i);
            if (i < w_.bone_count() && w_.kind(i) == BoneKind::tube && !leads_to_pit(i)) add_on_bone(i);
        }
        if (!w_.closed && !w_.far.any()) add_end(true);
    }

  private:
    bool leads_to_pit(std::int32_t bone) const {
        const auto is_pit = [&](std::int32_t i) { return w_.s.cap[w_.node(i)] == Cap::pit; };
        return is_pit(bone) || is_pit(bone + 1);
    }

    /// Direction of a bone as its rings see it. Where a path turns straight back into itself it bores a hole:
    /// its rings go on as the same tube, inwards, and are not turned over.
    Vec3 way(std::int32_t bone) const {
        const Vec3 direction = w_.direction(bone);
        return bored_.empty() || !bored_[bone] ? direction : Vec3(-direction);
    }
    void find_bores() {
        bored_.clear();
        bool inside = false, any = false;
        for (std::int32_t b = 0; b < w_.bone_count(); ++b) {
            if (b > 0 && w_.direction(b - 1).dot(w_.direction(b)) < -0.999) inside = !inside, any = true;
            bored_.push_back(inside);
        }
        if (!any || (w_.near.any() && w_.far.any() && inside)) return bored_.clear();
        const bool outer = w_.near.any() ? false : w_.far.any() ? inside : bored_[widest_bone()] != 0;
        for (std::uint8_t& bore : bored_) bore = (bore != 0) != outer;
    }
    std::int32_t widest_bone() const {
        const auto width = [&](std::int32_t b) { return w_.radius(b) + w_.radius(b + 1); };
        std::int32_t widest = 0;
        for (std::int32_t b = 1; b < w_.bone_count(); ++b)
            if (width(b) > width(widest)) widest = b;
        return widest;
    }

    double edge(double radius) const { return w_.edge * radius; }
    bool is_fixed(std::int32_t i) const {
        return w_.form(i) && w_.form(i)->kind == Form::Kind::ring && w_.form(i)->fixed;
    }
    bool is_shaped(std::int32_t i) const {
        const Form* f = w_.form(i);
        return f && f->kind == Form::Kind::ring &&
               (f->section == Section::rectangular || f->half.x() != f->half.y());
    }

    /// How far the ring at a node leans over its bones, on the inner side of the bend.
    double lean(std::int32_t i) const {
        if (is_fixed(i)) return 0;
        const double cosine = std::clamp(way(i - 1).dot(way(i)), -1.0, 1.0);
        return w_.radius(i) * std::min(1.0, std::sqrt((1 - cosine) / (1 + cosine + 1e-12)));
    }

    /// Whether a place is seen from a joint through its cell, or hardly beside it.
    bool in_cell(const JointSide& side, const Vec3& place) const {
        constexpr double hardly = 0.1;                  // sine
        const double turn = &side == &w_.far ? -1 : 1;  // its points go clockwise
        const Vec3 to = (place - side.centre).normalized();
        const Vec3* before = &side.points.back();
        for (const Vec3& point : side.points) {
            const Vec3 wall = before->cross(point);
            if (turn * wall.dot(to) < -hardly * wall.norm()) return false;
            before = &point;
        }
        return true;
    }
    /// Rings inside a joint's own part are left out, but for those that were asked for, and those from which
    /// the path turns into its neighbours' part.
    void leave_out_nodes() {
        const auto inside = [&](const JointSide& side, std::int32_t i, std::int32_t next, const Vec3& axis) {
            if (is_fixed(i)) return false;
            const Vec3 from = w_.position(i) - side.centre;
            const double r = w_.radius(i);
            if (const Form* body = w_.points.body[side.joint]; body && body->kind != Form::Kind::blend)
                return from.norm() <
                       exit_of_joint(w_.n, w_.points, side.joint, side.centre, from.normalized());
            return from.dot(axis) - lean(i) < side.reach + 0.1 * r && from.norm() < side.farthest + 0.1 * r &&
                   in_cell(side, w_.position(next));
        };
        const std::int32_t last = w_.count() - 1;
        if (w_.near.any())
            for (std::int32_t i = 1; i < last && inside(w_.near, i, i + 1, w_.direction(0)); ++i)
                kept_[i] = 0;
        if (w_.far.any())
            for (std::int32_t i = last - 1; i > 0 && inside(w_.far, i, i - 1, -w_.direction(last - 1)); --i)
                kept_[i] = 0;
    }

    Station& add(const Vec3& centre, const Vec3& tangent, double radius, std::int32_t bone, double along) {
        Station ring;
        ring.centre = centre;
        ring.tangent = tangent;
        ring.half = {radius, radius};
        ring.bone = w_.bones[bone];
        const bool forward = w_.s.bones[ring.bone][0] == w_.node(bone);
        ring.along = static_cast<float>(std::clamp(forward ? along : 1 - along, 0.0, 1.0));
        ring.node = w_.node(along > 0.5 ? bone + 1 : bone);
        return w_.rings.emplace_back(ring);
    }

    void add_at_node(std::int32_t i) {
        const Vec3 in = way(i - 1), out = way(i), sum = in + out;
        Station& ring = add(w_.position(i), sum.norm() > 1e-6 ? sum.normalized() : in, w_.radius(i),
                            i % w_.bone_count(), 0);
        ring.node = w_.node(i);
        ring.before = w_.node(i - 1);
        ring.after = w_.node(i + 1);
        ring.shape = RingShape::node;
        if (w_.options.support && is_base_of_tip(i)) ring.fit = RingFit::held;
        const Form* form = w_.form(i);
        if (!form || form->kind != Form::Kind::ring) return;
        take_form(ring, *form);
        if (!form->fixed) {
            const Vec3 askew = out - in;
            const double cosine = std::sqrt(std::max(0.25, (1 + in.dot(out)) / 2));
            if (askew.norm() > 1e-9) ring.bend = (1 / cosine - 1) * askew.normalized();
        }
        ring.to_next = w_.kind(i);
        if (ring.to_next == BoneKind::plate) ring.lines = 0;
    }

    /// Gives a ring the outline of a form, turned into its plane or with its plane.
    void take_form(Station& ring, const Form& form) {
        Frame frame{form.x, form.y, form.z};
        if (frame.z.dot(ring.tangent) < 0) frame = {frame.x, -frame.y, -frame.z};
        if (form.fixed)
            ring.tangent = frame.z;
        else
            frame = turn_frame(frame, ring.tangent);
        ring.form_x = frame.x;
        ring.half = {form.half.x(), form.half.y()};
        const bool rectangular = form.section == Section::rectangular;
        const bool plain =
            !rectangular && ring.half.x() == ring.half.y() && !form.fixed && form.sharpness == 0;
        if (plain) return;  // stays on the round cones
        ring.shape = rectangular ? RingShape::outline : RingShape::circle;
        ring.crease = static_cast<float>(form.sharpness);
        if (form.fixed) {
            ring.round = !rectangular && ring.half.x() == ring.half.y();
            ring.corners = rectangular;
        }
        if (rectangular) ring.lines = static_cast<float>(infinitely_sharp);
    }

    void add_end(bool at_end) {
        const std::int32_t leaf = at_end ? w_.count() - 1 : 0;
        switch (w_.s.cap[w_.node(leaf)]) {
            case Cap::round:
                add_round_end(leaf, at_end);
                break;
            case Cap::flat:
                add_flat_end(leaf, at_end);
                break;
            case Cap::pit:
                add_pit(leaf, at_end);
                break;
            case Cap::point:
            case Cap::surface:
                break;
        }
    }

    /// Rings of a round end: from where the cone touches the ball to just before the pole.
    void add_round_end(std::int32_t leaf, bool at_end) {
        const std::int32_t other = at_end ? leaf - 1 : 1;
        const Vec3 outward = (w_.position(leaf) - w_.position(other)).normalized();
        const double length = (w_.position(leaf) - w_.position(other)).norm(), r = w_.radius(leaf);
        const Form* form = is_shaped(leaf) ? w_.form(leaf) : nullptr;
        const double begin =
            form ? 0 : portable::arc_sine(std::clamp((w_.radius(other) - r) / length, -0.9, 0.9));
        const int rings =
            std::max(1, static_cast<int>(std::lround(w_.sides * (M_PI / 2 - begin) / (2 * M_PI))));
        for (int i = 0; i < rings; ++i) {
            const int step = at_end ? i : rings - 1 - i;
            const double angle = begin + (M_PI / 2 - begin) * step / rings;
            const auto [sine, cosine] = portable::sine_cosine(angle);
            const Vec3 centre = w_.position(leaf) + r * sine * outward;
            if (at_end && w_.near.any() && w_.count() == 2 && length + r * sine < w_.near.reach + 0.15 * r)
                continue;
            Station& ring =
                add(centre, way(at_end ? leaf - 1 : 0), r * cosine, at_end ? leaf - 1 : 0, at_end ? 1 : 0);
            ring.node = w_.node(leaf);
            ring.fit = RingFit::cap;
            if (!form) continue;
            take_form(ring, *form);
            if (ring.shape != RingShape::circle || ring.crease > 0) ring.fit = RingFit::through;
            ring.half *= cosine;
            ring.crease = step == 0 ? ring.crease : 0;
        }
    }

    void add_flat_end(std::int32_t leaf, bool at_end) {
        const Vec3 along = way(at_end ? leaf - 1 : 0);
        Station& ring = add(w_.position(leaf), along, w_.radius(leaf), at_end ? leaf - 1 : 0, at_end ? 1 : 0);
        ring.node = w_.node(leaf);
        if (const Form* form = w_.form(leaf)) take_form(ring, *form);
        if (!at_end && w_.kind(0) != BoneKind::tube) ring.to_next = w_.kind(0);
        if (at_end) ring.lines = 0;
    }

    /// The rim of a dent and the rings down its wall; their places are the joint's to say.
    void add_pit(std::int32_t leaf, bool at_end) {
        const JointSide& side = at_end ? w_.near : w_.far;
        if (!side.any()) return;
        const PathEnd& end = w_.n.path_end[w_.path][at_end ? 0 : 1];
        const PitShape& pit = w_.points.pits[w_.points.extra[w_.n.slot_first[end.joint] + end.slot]];
        const Form* form = w_.form(leaf);
        for (const float width : pit_rings) {
            Station& ring = add(pit.middle, at_end ? pit.z : Vec3(-pit.z), pit.half.x(),
                                at_end ? leaf - 1 : 0, at_end ? 1 : 0);
            ring.node = w_.node(leaf);
            ring.shape = RingShape::pit;
            ring.form_x = pit.x;
            ring.half = {pit.half.x(), pit.half.y()};
            ring.share = width;
            ring.far = !at_end;
            if (width == 1.0f && form) ring.crease = static_cast<float>(form->sharpness);
        }
    }

    /// Part of a bone that is free for rings, as heights above its first node.
    std::pair<double, double> free_part(std::int32_t bone, const ConeFrom& cone) const {
        const auto end = [&](std::int32_t i, const JointSide& side, bool last) {
            if (!w_.closed && (last ? i == w_.count() - 1 : i == 0)) {
                if (side.any()) return side.reach;
                return last ? cone.length - cone.side_end() : cone.side_begin();
            }
            return kept_[i % w_.count()] ? std::min(lean(i), 0.5 * cone.length) : cone.length;
        };
        return {end(bone, w_.near, false), cone.length - end(bone + 1, w_.far, true)};
    }

    /// Whether a bone begins, at this node, at a joint's own ring or at the place where a body lets it out.
    bool leaves_joint(std::int32_t i, bool at_near) const {
        if (w_.form(i) && w_.form(i)->kind == Form::Kind::box) return false;  // a beam that goes on flush
        if (!w_.closed && (at_near ? i == 0 && w_.near.any() : i == w_.count() - 1 && w_.far.any()))
            return true;
        if (!is_fixed(i) || w_.form(i)->section != Section::round) return false;
        const std::int32_t beyond = at_near ? i - 1 : i;  // the bone on the other side of the node
        return w_.is_inner(i) && w_.kind((beyond + w_.bone_count()) % w_.bone_count()) != BoneKind::tube;
    }

    /// Whether this node is a round end, the base of a tip or a sharp bend, beside which a smooth surface
    /// swings out unless rings hold it.
    bool wants_support(std::int32_t i) const {
        if (!w_.options.support) return false;
        const std::int32_t last = w_.count() - 1;
        if (!w_.closed && (i == 0 || i == last))
            return !(i == 0 ? w_.near : w_.far).any() && w_.s.cap[w_.node(i)] == Cap::round &&
                   !is_rectangular(i);
        return is_base_of_tip(i) || is_bend(i);
    }
    bool is_base_of_tip(std::int32_t i) const {
        if (w_.closed) return false;
        const bool tip = (i == 1 && w_.s.cap[w_.node(0)] == Cap::point) ||
                         (i + 2 == w_.count() && w_.s.cap[w_.node(i + 1)] == Cap::point);
        if (!tip || (w_.form(i) && w_.form(i)->kind == Form::Kind::ring)) return false;
        return std::abs(slope(i - 1) - slope(i)) > corner;
    }
    bool is_bend(std::int32_t i) const {
        const Form* form = w_.form(i);
        if (form && (form->kind != Form::Kind::ring || form->fixed || form->sharpness > 0)) return false;
        const auto is_tube = [&](std::int32_t bone) {
            return w_.kind((bone + w_.bone_count()) % w_.bone_count()) == BoneKind::tube;
        };
        return is_tube(i - 1) && is_tube(i) && w_.direction(i - 1).dot(w_.direction(i)) < straight;
    }
    bool is_rectangular(std::int32_t i) const {
        const Form* f = w_.form(i);
        return f && f->kind == Form::Kind::ring && f->section == Section::rectangular;
    }
    double slope(std::int32_t bone) const {
        return portable::angle_of(w_.radius(bone + 1) - w_.radius(bone),
                                  (w_.position(bone + 1) - w_.position(bone)).norm());
    }

    /// Rings along a bone: one beside each joint, so that the tube keeps its radius from there on, and some
    /// where a steep cone touches the balls at its ends.
    void add_on_bone(std::int32_t bone) {
        const ConeFrom cone(w_.position(bone), w_.radius(bone), w_.position(bone + 1), w_.radius(bone + 1));
        if (cone.nested()) return;
        const std::pair<double, double> free = free_part(bone, cone);
        const double low = free.first, high = free.second;  // clang 14: a lambda takes no structured binding
        const bool hold_near = wants_support(bone), hold_far = wants_support(bone + 1);
        const bool at_near = !hold_near && leaves_joint(bone, true),
                   at_far = !hold_far && leaves_joint(bone + 1, false);
        const double low_edge = edge(cone.radius_at(low)), high_edge = edge(cone.radius_at(high)),
                     room = high - low;
        heights_.clear();
        if (at_near && at_far && room <= 0.75 * (low_edge + high_edge)) {
            if (room > 0.4 * (low_edge + high_edge)) heights_.push_back((low + high) / 2);
        } else {
            const double part = hold_near || hold_far ? room / 2 : room;
            if (at_near && part > 1.25 * low_edge) heights_.push_back(low + 0.4 * low_edge);
            if (at_far && part > 1.25 * high_edge) heights_.push_back(high - 0.4 * high_edge);
        }
        const double part = hold_near && hold_far ? room / 2 : at_near || at_far ? 0.6 * room : room;
        if (hold_near) offer_support(low, 1, low_edge, part);
        if (hold_far) offer_support(high, -1, high_edge, part);
        const bool shaped =
            is_shaped(bone) || is_shaped(bone + 1) || shaped_joint(bone) || shaped_joint(bone + 1);
        if (!shaped) offer_steep(bone, cone, low, high);
        std::sort(heights_.begin(), heights_.end());
        for (const double height : heights_) {
            Station& ring = add(w_.position(bone) + height * cone.axis, way(bone), cone.radius_at(height),
                                bone, height / cone.length);
            if (hold_near || hold_far) ring.fit = RingFit::held;
            if (shaped) blend(ring, bone, height / cone.length);
        }
    }
    /// Two rings beside one that the smooth surface bends at: from the second on it is as without the bend.
    void offer_support(double from, double sign, double edge, double room) {
        if (room > 0.9 * edge) {
            heights_.push_back(from + sign * 0.3 * edge);
            heights_.push_back(from + sign * 0.65 * edge);
        } else if (room > 0.3 * edge) {
            heights_.push_back(from + sign * 0.5 * room);
        }
    }
    bool shaped_joint(std::int32_t i) const {
        const Form* f = w_.form(i);
        return f && f->kind == Form::Kind::blend &&
               (f->section == Section::rectangular || f->half.x() != f->half.y());
    }

    void offer_steep(std::int32_t bone, const ConeFrom& cone, double low, double high) {
        const auto offer = [&](double height) {
            const double gap = 0.3 * edge(cone.radius_at(height));
            if (height < low + gap || height > high - gap) return;
            for (const double h : heights_)
                if (std::abs(h - height) < gap) return;
            heights_.push_back(height);
        };
        const double half_slope = cone.sine / std::sqrt(2 * (1 + cone.cosine));  // sine of half the angle
        const bool from_leaf = !w_.closed && bone == 0 && !w_.near.any();
        const bool to_leaf = !w_.closed && bone + 1 == w_.bone_count() && !w_.far.any();
        if (cone.sine > steep && !from_leaf) offer(cone.side_begin());
        if (cone.sine > very_steep) offer(cone.near * half_slope);
        if (cone.sine < -steep && !to_leaf) offer(cone.side_end());
        if (cone.sine < -very_steep) offer(cone.length + cone.far * half_slope);
    }

    /// A ring between two outlines has the outline between them; a rectangle only between two of them.
    void blend(Station& ring, std::int32_t bone, double share) {
        const auto outline = [&](std::int32_t i) {
            const Form* f = w_.form(i);
            return f && f->kind != Form::Kind::ball && f->kind != Form::Kind::box ? f : nullptr;
        };
        const Form *a = outline(bone), *b = outline(bone + 1);
        const Form* leads = is_shaped(bone) ? a : b ? b : a;
        if (!leads) return;
        Form form = *leads;
        form.fixed = false;
        form.sharpness = 0;
        const auto half = [&](const Form* f, std::int32_t i) -> Vec3 {
            return f ? f->half : Vec3(Vec3::Constant(w_.radius(i)));
        };
        form.half = (1 - share) * half(a, bone) + share * half(b, bone + 1);
        if (!a || !b || a->section != b->section) form.section = Section::round;
        take_form(ring, form);
    }

    PathWork& w_;
    std::vector<std::uint8_t>& kept_;
    std::vector<std::uint8_t> bored_;  // bone -> whether it bores; empty if none does
    std::vector<double>& heights_;
};

}  // namespace

void place_rings(PathWork& work, bool keep_all) { RingPlacer(work, keep_all).run(); }

}  // namespace sinew::sqm
