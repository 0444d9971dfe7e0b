#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <climits>

#include "actions/action.h"

namespace sinew::modeler {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool starts_word(std::string_view text, std::size_t i) {
    return i == 0 || text[i - 1] == ' ' || text[i - 1] == '>';
}

/// How badly `text` matches: 0 at best; INT_MAX where its letters are not all there in order.
int mismatch(std::string_view text, std::string_view wanted) {
    int cost = 0;
    std::size_t at = 0;
    for (char c : wanted) {
        if (c == ' ') continue;
        const std::size_t from = at;
        while (at < text.size() && lower(text[at]) != lower(c)) ++at;
        if (at == text.size()) return INT_MAX;
        if (at > from && !starts_word(text, at)) cost += 5;
        cost += std::min<int>(static_cast<int>(at - from), 4);
        ++at;
    }
    return cost;
}

int mismatch(const Action& action, std::string_view wanted) {
    const int in_name = mismatch(action.name, wanted);
    if (in_name != INT_MAX) return in_name;
    const std::string_view tip = action.tip;
    auto place = std::search(tip.begin(), tip.end(), wanted.begin(), wanted.end(),
                             [](char a, char b) { return lower(a) == lower(b); });
    return place == tip.end() ? INT_MAX : 1000 + static_cast<int>(place - tip.begin());
}

std::vector<Action> gathered() {
    std::vector<Action> all;
    for (auto part :
         {file_actions(), edit_actions(), select_actions(), drawing_actions(), operation_actions(),
          type_actions(), symmetry_actions(), view_actions(), help_actions()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::string keys_of(const Action& action) {
    std::string keys = action.shortcut;
    for (std::size_t i; (i = keys.find(" | ")) != std::string::npos;) keys.replace(i, 3, " or ");
    return keys;
}

}  // namespace

std::span<const Action> actions() {
    static const std::vector<Action> all = gathered();
    return all;
}

const Action* find_action(std::string_view id) {
    for (const Action& action : actions())
        if (action.id == id) return &action;
    return nullptr;
}

std::string_view name_of(Menu menu) {
    constexpr std::string_view names[] = {"File", "Edit", "Select", "Skeleton", "View", "Help"};
    return names[static_cast<int>(menu)];
}

std::vector<const Action*> search_actions(std::string_view text) {
    std::vector<std::pair<int, const Action*>> found;
    for (const Action& action : actions())
        if (const int cost = mismatch(action, text); cost != INT_MAX) found.emplace_back(cost, &action);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const Action*> result;
    for (const auto& [cost, action] : found) result.push_back(action);
    return result;
}

std::string keys_as_markdown() {
    std::string text;
    Menu menu = Menu::help;
    for (const Action& action : actions()) {
        if (text.empty() || action.menu != menu)
            text += fmt::format("{}### {}\n\n| Action | Keys | What it does |\n|---|---|---|\n",
                                text.empty() ? "" : "\n", name_of(action.menu));
        menu = action.menu;
        text += fmt::format("| {} | {} | {} |\n", action.name, keys_of(action), action.tip);
    }
    return text;
}

}  // namespace sinew::modeler
