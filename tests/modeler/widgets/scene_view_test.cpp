#include "viewport/scene_view.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "render/draw_calls.h"
#include "sinew/render/egl_context.h"
#include "sinew/render/offscreen.h"
#include "tree.h"
#include "viewport/navigation.h"

namespace sinew::modeler {
namespace {

const Vec2 size(320, 240);

/// The viewport's layers on a card without a window.
struct Card {
    EglContext context;
    Offscreen picture;
    SceneView scene;
    Model model;
    Interaction tools{model};
    ViewSettings view;
    Camera camera;

    static std::unique_ptr<Card> create() {
        auto context = EglContext::create();
        if (!context) return nullptr;
        auto picture = Offscreen::create(static_cast<int>(size.x()), static_cast<int>(size.y()));
        auto scene = SceneView::create();
        return std::unique_ptr<Card>(new Card{std::move(*context), std::move(*picture), std::move(*scene)});
    }
    void show(Document document, int level) {
        model.replace(std::move(document), true);
        scene.set_mesh(std::make_shared<LiveMesh>(Pipeline().run(model.document(), {.level = level})));
        camera = framed(home_camera(), bounds_of(model.document(), all_nodes(model.document()).nodes), size);
    }
    Picture draw() {
        picture.begin({0, 0, 0, 255});
        scene.draw(model, tools, view, camera, static_cast<int>(size.x()), static_cast<int>(size.y()), 1);
        return picture.read();
    }
    int calls() {
        draw();  // epoxy has looked everything up, and buffers are there
        const DrawCalls counter;
        draw();
        return DrawCalls::count;
    }
};

/// A chain with every type that a tip can have, again and again.
Document forest(int trees) {
    Document document;
    document.symmetry = {Symmetry::Kind::mirror, 0, 1};
    const NodeType types[] = {NodeType::sphere, NodeType::cone,     NodeType::hemisphere,
                              NodeType::cube,   NodeType::negative, NodeType::ball};
    for (int i = 0; i < trees; ++i) {
        const auto root = static_cast<std::int32_t>(document.nodes.size());
        document.nodes.push_back({.id = root, .position = Vec3(2 + i % 40, i / 40, 0), .radius = 0.2});
        document.nodes.push_back({.id = root + 1,
                                  .parent = root,
                                  .position = Vec3(2 + i % 40, i / 40, 1),
                                  .radius = 0.2,
                                  .type = types[i % 6]});
    }
    return document;
}

#define SKIP_WITHOUT_EGL(card) \
    if (!(card)) GTEST_SKIP() << "there is no EGL"

TEST(SceneView, draws_a_handful_of_calls_however_much_there_is) {
    const auto card = Card::create();
    SKIP_WITHOUT_EGL(card);
    card->view.irregular = card->view.creases = true;
    card->show(forest(6), 0);
    const int few = card->calls();
    card->show(forest(600), 1);
    EXPECT_EQ(card->calls(), few);
    // The mesh, a call a shape of glyph, bones, irregular vertices, creases, planes.
    EXPECT_LE(few, 14);
    card->view.opacity = 0.5;
    EXPECT_LE(card->calls(), few + 2);
}

TEST(SceneView, bones_are_seen_through_a_mesh_that_is_not_opaque) {
    const auto card = Card::create();
    SKIP_WITHOUT_EGL(card);
    card->show(small_tree(), 2);
    card->view.bones = false;
    const Picture opaque = card->draw();
    card->view.opacity = 0.4;
    const Picture through = card->draw();
    card->view.bones = true;
    const Picture with_bones = card->draw();
    EXPECT_NE(opaque.pixels, through.pixels);
    EXPECT_NE(through.pixels, with_bones.pixels);
}

TEST(SceneView, a_frame_again_is_the_same_frame) {
    const auto card = Card::create();
    SKIP_WITHOUT_EGL(card);
    card->show(small_tree(), 1);
    const Picture first = card->draw();
    EXPECT_EQ(card->draw().pixels, first.pixels);
    card->model.select(selection_of(2));
    EXPECT_NE(card->draw().pixels, first.pixels);
    card->model.select({});
    EXPECT_EQ(card->draw().pixels, first.pixels);
}

TEST(SceneView, without_a_live_mesh_there_are_bones_alone) {
    const auto card = Card::create();
    SKIP_WITHOUT_EGL(card);
    card->show(small_tree(), 1);
    const Picture with_mesh = card->draw();
    card->view.live = false;
    const Picture without = card->draw();
    EXPECT_NE(with_mesh.pixels, without.pixels);
    card->scene.set_mesh(nullptr);
    EXPECT_EQ(card->draw().pixels, without.pixels);
}

}  // namespace
}  // namespace sinew::modeler
