// What a hand may do in any order: pointer, keys, actions and panels at random. Whatever comes of it is a
// sound document, and its history leads back to the first byte and forth to the last.

#include <gtest/gtest.h>

#include <random>

#include "document/fields.h"
#include "fake_host.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"
#include "stage.h"
#include "whole_history.h"

namespace sinew::modeler {
namespace {

class Chaos {
  public:
    explicit Chaos(unsigned seed) : random_(seed) {
        desk_.host.chaos = this;
        desk_.model.replace(starting_document(), true);
        beginning_ = bytes_of(desk_.model.document());
    }

    /// @return how many steps there were to take back
    int run(int events) {
        for (int i = 0; i < events && !testing::Test::HasFailure(); ++i) {
            one_event();
            check();
        }
        desk_.tools.cancel();
        desk_.model.cancel();
        return expect_whole_history(desk_.model, beginning_);
    }

  private:
    int below(int n) { return std::uniform_int_distribution(0, n - 1)(random_); }
    bool chance(int of) { return below(of) == 0; }
    const Document& document() const { return desk_.model.document(); }
    Interaction& tools() { return desk_.tools; }

    /// Mostly at a node, so that something is taken hold of.
    Pointer somewhere() {
        Pointer pointer{{below(800), below(600)}, chance(4), chance(4)};
        if (!chance(3) && !document().nodes.empty())
            if (const auto at = screen_.project(document().nodes[below(nodes())].position))
                pointer.pixel = *at;
        return pointer;
    }
    int nodes() const { return static_cast<int>(document().nodes.size()); }

    void one_event() {
        // The document is kept small: what matters is the order of things.
        if (nodes() > 40) return thin_out();
        switch (below(16)) {
            case 0:
            case 1:
                return tools().press(somewhere(), screen_);
            case 2:
            case 3:
            case 4:
                return tools().move(somewhere(), screen_);
            case 5:
            case 6:
                return tools().release(somewhere(), screen_);
            case 7:
                return void(tools().wheel(somewhere(), screen_, below(5) - 2));
            case 8:
                return void(tools().type("xyzXYZ0123456789.-\b?"[below(20)], screen_));
            case 9:
                return void(tools().start(static_cast<Modal>(below(5)), somewhere(), screen_));
            case 10:
                return chance(3) ? tools().cancel() : chance(3) ? tools().leave() : tools().finish();
            case 11:
                return type_in_a_panel();
            case 12:
                screen_ = chance(2) ? front_screen() : perspective_screen();
                return void(tools().look_again(screen_));
            default:
                return run_action(actions()[below(static_cast<int>(actions().size()))].id);
        }
    }
    /// From a menu: also in the middle of a gesture.
    void run_action(const char* id) {
        if (desk_.enabled(id)) desk_.run(id);
    }
    void thin_out() {
        Selection most;
        for (int i = 3; i < nodes(); ++i) most.nodes.push_back(i);
        Edited edit = erase_nodes(document(), most);
        desk_.model.apply("Delete", std::move(edit.document), std::move(edit.selection));
    }
    void type_in_a_panel() {
        const std::vector<std::int32_t>& chosen = desk_.model.selection().nodes;
        const Field& field = fields()[below(static_cast<int>(fields().size()))];
        if (chosen.empty() || !relevant_to_all(document(), chosen, field)) return;
        desk_.model.apply(field.group, with_value(document(), chosen, field, 0.1 * below(40)));
    }

    void check() {
        const Result<void> sound = validate(document());
        EXPECT_TRUE(sound) << sound.error().text();
        const Selection& selection = desk_.model.selection();
        for (std::int32_t node : selection.nodes) EXPECT_LT(node, nodes());
        EXPECT_TRUE(selection.active < 0 ? selection.empty() : selection.contains(selection.active));
        // What is painted after every event.
        EXPECT_EQ(tools().glyphs().nodes.size(), document().nodes.size());
        const Hit& hit = tools().hovered();
        EXPECT_LT(hit.index, hit.kind == Hit::Kind::bone ? std::ssize(bones_of(document())) : nodes());
        EXPECT_EQ(tools().hint().empty(), !tools().active());
        for (const Guides::Line& line : tools().guides().lines) EXPECT_TRUE(line.to.allFinite());
        EXPECT_TRUE(tools().active() || !desk_.model.previewing());
    }

    /// What a window would do for the actions that need one.
    class HandyHost : public FakeHost {
      public:
        Chaos* chaos = nullptr;
        void start(Modal modal) override { chaos->tools().start(modal, chaos->somewhere(), chaos->screen_); }
        void insert_node() override {
            const Hit& hit = chaos->tools().hovered();
            if (hit.kind != Hit::Kind::bone) return;
            Edited edit = insert_on_bone(chaos->document(), hit.index, hit.along);
            chaos->desk_.model.apply("Insert", std::move(edit.document), std::move(edit.selection));
        }
        void perform(Operation operation) override {
            const auto after = operation.run(values_of(operation));
            Model& model = chaos->desk_.model;
            if (after)
                model.apply(operation.label, *after, carried(model.document(), model.selection(), *after));
        }
    };

    DeskWith<HandyHost> desk_;
    Screen screen_ = front_screen();
    std::mt19937 random_;
    std::string beginning_;
};

TEST(Chaos, leaves_a_sound_document_and_a_whole_history) {
    int steps = 0;
    for (unsigned seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        steps += Chaos(seed).run(400);
        if (HasFailure()) return;
    }
    EXPECT_GT(steps, 40 * 500);  // something was done
}

}  // namespace
}  // namespace sinew::modeler
