// The table of actions (actions/*.cpp).

#include <gmock/gmock.h>

#include <QKeySequence>
#include <QStringList>
#include <map>
#include <set>

#include "document/delta.h"
#include "document/edits.h"
#include "fake_host.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

QStringList keys_of(const Action& action) {
    return QString(action.shortcut).split(" | ", Qt::SkipEmptyParts);
}

/// A root with two limbs, and another root far away.
Document limbs() {
    Document document = starting_document();
    document.symmetry = {};
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(1, 0, 2), .radius = 0.3});
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(-1, 0, 2), .radius = 0.3});
    append_node(document, {.id = -1, .position = Vec3(9, 0, 0), .radius = 0.4});
    return document;
}

TEST(Actions, each_says_what_it_is) {
    std::set<std::string> ids, names;
    for (const Action& action : actions()) {
        EXPECT_TRUE(ids.insert(action.id).second) << action.id;
        EXPECT_TRUE(names.insert(action.name).second) << action.name;
        EXPECT_FALSE(std::string(action.name).empty()) << action.id;
        const std::string tip = action.tip;
        EXPECT_GE(tip.size(), 8u) << action.id;
        EXPECT_TRUE(std::isupper(static_cast<unsigned char>(tip[0]))) << action.id;
        EXPECT_NE(tip.back(), '.') << action.id;
        EXPECT_TRUE(action.run) << action.id;
        EXPECT_EQ(find_action(action.id), &action);
    }
    EXPECT_EQ(find_action("no.such"), nullptr);
}

TEST(Actions, no_two_have_the_same_key) {
    std::map<QString, std::string> owner;
    for (const Action& action : actions())
        for (const QString& text : keys_of(action)) {
            const QKeySequence key = QKeySequence::fromString(text, QKeySequence::PortableText);
            ASSERT_EQ(key.count(), 1) << action.id;
            EXPECT_NE(key[0].key(), Qt::Key_unknown) << action.id;
            const auto [place, fresh] = owner.emplace(key.toString(QKeySequence::PortableText), action.id);
            EXPECT_TRUE(fresh) << text.toStdString() << " is " << place->second << " and " << action.id;
        }
}

TEST(Actions, the_keys_that_users_of_the_method_know) {
    const std::map<const char*, const char*> known{
        {"Space", "view.live"},
        {"Shift+C", "node.consolidate"},
        {"M", "node.merge"},
        {"X", "edit.delete"},
        {"L", "node.link"},
        {"B", "node.insert"},
        {"E", "node.extrude"},
        {"R", "node.reroot"},
        {"Ctrl+D", "edit.duplicate"},
        {"Ctrl+Z", "edit.undo"},
        {"Ctrl+Shift+Z", "edit.redo"},
        {"F", "view.frame"},
        {"Home", "view.frame_all"},
        {"Num+1", "view.front"},
        {"Num+3", "view.right"},
        {"Num+7", "view.top"},
        {"Num+5", "view.perspective"},
        {"W", "view.wire"},
        {"0", "view.level0"},
        {"4", "view.level4"},
        {"F3", "help.palette"},
        {"Ctrl+K", "help.palette"},
        {"F1", "help.keys"},
        {"S", "node.scale"},
    };
    for (const auto& [key, id] : known) {
        const Action* action = find_action(id);
        ASSERT_TRUE(action) << id;
        EXPECT_THAT(keys_of(*action), Contains(QString(key))) << id;
    }
}

TEST(Actions, what_needs_a_selection_waits_for_one) {
    Desk desk;
    desk.model.replace(limbs(), true);
    for (const char* id : {"edit.delete", "edit.duplicate", "node.extrude", "type.cone", "node.link",
                           "select.linked", "edit.rename", "node.reroot", "select.none"}) {
        desk.model.select({});
        EXPECT_FALSE(desk.enabled(id)) << id;
        desk.model.select(selection_of(1));
        EXPECT_TRUE(desk.enabled(id)) << id;
    }
}

TEST(Actions, undo_and_save_follow_the_history) {
    Desk desk;
    desk.model.replace(limbs(), true);
    for (const char* id : {"edit.undo", "edit.redo", "file.save"}) EXPECT_FALSE(desk.enabled(id)) << id;
    desk.model.select(selection_of(1));
    desk.run("edit.delete");
    EXPECT_TRUE(desk.enabled("edit.undo"));
    EXPECT_TRUE(desk.enabled("file.save"));
    desk.run("edit.undo");
    EXPECT_TRUE(same(desk.model.document(), limbs()));
    EXPECT_TRUE(desk.enabled("edit.redo"));
    EXPECT_FALSE(desk.enabled("file.save"));
}

TEST(Actions, an_empty_document_offers_nothing_to_do_with_nodes) {
    Desk desk;
    desk.model.replace({}, true);
    for (const char* id : {"select.all", "view.frame", "file.export", "node.insert", "node.merge"})
        EXPECT_FALSE(desk.enabled(id)) << id;
    for (const char* id : {"node.root", "file.open", "view.wire", "help.keys", "tool.draw"})
        EXPECT_TRUE(desk.enabled(id)) << id;
}

TEST(Actions, whatever_is_enabled_leaves_a_sound_document) {
    const Selection selections[] = {{},
                                    selection_of(0),
                                    selection_of(1),
                                    selection_of(std::vector<std::int32_t>{1, 2}),
                                    selection_of(std::vector<std::int32_t>{0, 1, 2, 3})};
    for (const Document& document : {Document{}, starting_document(), limbs()})
        for (const Selection& selection : selections)
            for (const Action& action : actions()) {
                if (!selection.nodes.empty() && selection.nodes.back() >= std::ssize(document.nodes))
                    continue;
                Desk desk;
                desk.model.replace(document, true);
                desk.model.select(selection);
                if (action.enabled && !action.enabled(desk.context)) continue;
                action.run(desk.context);
                const Result<void> sound = validate(desk.model.document());
                EXPECT_TRUE(sound) << action.id << ": " << sound.error().text();
                for (std::int32_t node : desk.model.selection().nodes)
                    EXPECT_LT(node, std::ssize(desk.model.document().nodes)) << action.id;
                while (desk.model.history().canUndo()) desk.model.undo();
                EXPECT_TRUE(same(desk.model.document(), document)) << action.id;
            }
}

TEST(Actions, what_is_checked_is_what_was_chosen) {
    for (const Action& action : actions()) {
        if (!action.checked) continue;
        Desk desk;
        desk.model.replace(limbs(), true);
        desk.model.select(selection_of(1));
        const bool before = action.checked(desk.context);
        action.run(desk.context);
        if (!desk.host.asked.empty()) continue;  // a dialog would ask first
        // One of several is on after it, a switch the other way round.
        const bool choice = std::string_view(action.name).find(" > ") != std::string_view::npos ||
                            std::string(action.id).starts_with("tool.");
        EXPECT_EQ(action.checked(desk.context), choice || !before) << action.id;
    }
}

TEST(Actions, steps_are_named_after_what_was_done) {
    Desk desk;
    desk.model.replace(limbs(), true);
    desk.model.select(selection_of(1));
    for (const auto& [id, label] : {std::pair{"type.cone", "Type"},
                                    {"node.joint", "Joint"},
                                    {"symmetry.y", "Symmetry"},
                                    {"edit.delete", "Delete"}}) {
        desk.run(id);
        EXPECT_EQ(desk.model.history().undoText(), label) << id;
    }
}

TEST(Actions, types_for_tips_are_refused_in_words_elsewhere) {
    Desk desk;
    desk.model.replace(limbs(), true);
    desk.model.select(selection_of(0));
    desk.run("type.cone");
    EXPECT_EQ(desk.model.document().nodes[0].type, NodeType::sphere);
    EXPECT_THAT(desk.host.asked, ElementsAre("message"));
}

TEST(SearchActions, all_for_nothing) { EXPECT_EQ(search_actions("").size(), actions().size()); }

TEST(SearchActions, finds_by_letters_words_and_meaning) {
    const auto first = [](const char* text) {
        const std::vector<const Action*> found = search_actions(text);
        return found.empty() ? std::string() : std::string(found.front()->id);
    };
    EXPECT_EQ(first("wire"), "view.wire");
    EXPECT_EQ(first("WIRE"), "view.wire");
    EXPECT_EQ(first("undo"), "edit.undo");
    EXPECT_EQ(first("frame all"), "view.frame_all");
    EXPECT_EQ(first("flat end"), "type.hemisphere");
    EXPECT_EQ(first("mir y"), "symmetry.y");
    EXPECT_EQ(first("closes a cycle"), "");
    EXPECT_EQ(first("close a cycle"), "node.link");  // of the tip
    EXPECT_THAT(search_actions("qqqq"), IsEmpty());
}

TEST(KeysAsMarkdown, has_a_row_for_each_action) {
    const std::string text = keys_as_markdown();
    for (const Action& action : actions()) {
        EXPECT_NE(text.find("| " + std::string(action.name) + " |"), std::string::npos) << action.id;
        EXPECT_NE(text.find(action.tip), std::string::npos) << action.id;
    }
    EXPECT_EQ(text.find(" | |\n"), std::string::npos);
}

}  // namespace
}  // namespace sinew::modeler
