#include "tests/demos/pages/check_page.h"

#include "tests/catch.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace pushfactor::tests {

namespace {

struct Tag {
    std::string name;
    bool closes = false;
    std::map<std::string, std::string> attributes{};
};

// A tag or a text between two tags, and the elements around it, outermost first.
struct Piece {
    bool is_tag = false;
    Tag tag{};
    std::string text{};
    std::vector<std::string> inside{};
};

Tag tag_of(const std::string& text) {
    Tag tag;
    static const std::regex name("^/?!?([a-zA-Z][a-zA-Z0-9]*)"), attribute("([a-z-]+)(?:=\"([^\"<]*)\")?");
    std::smatch found;
    if (!std::regex_search(text, found, name)) return tag;
    tag.name = found[1];
    tag.closes = text.front() == '/';
    const std::string rest = found.suffix();
    for (std::sregex_iterator i(rest.begin(), rest.end(), attribute), end; i != end; ++i)
        tag.attributes[(*i)[1]] = (*i)[2];
    return tag;
}

bool is_void(const std::string& name) {
    return name == "DOCTYPE" || name == "meta" || name == "img" || name == "input";
}

// Of a well-formed page; otherwise the calling test fails.
std::vector<Piece> pieces_of(const std::string& page) {
    std::vector<Piece> pieces;
    std::vector<std::string> open;
    for (std::size_t at = 0; at < page.size();) {
        const bool raw = !open.empty() && (open.back() == "style" || open.back() == "script");
        const auto next = std::min(raw ? page.find("</" + open.back(), at) : page.find('<', at), page.size());
        if (next > at) pieces.push_back({.text = page.substr(at, next - at), .inside = open});
        if (next == page.size()) break;
        const auto end = page.find('>', next);
        REQUIRE(end != std::string::npos);
        const Tag tag = tag_of(page.substr(next + 1, end - next - 1));
        INFO(page.substr(next, std::min<std::size_t>(80, page.size() - next)));
        REQUIRE(!tag.name.empty());
        if (tag.closes) {
            REQUIRE(!open.empty());
            REQUIRE(open.back() == tag.name);
            open.pop_back();
        }
        pieces.push_back({.is_tag = true, .tag = tag, .inside = open});
        if (!tag.closes && !is_void(tag.name)) open.push_back(tag.name);
        at = end + 1;
    }
    REQUIRE(open.empty());
    return pieces;
}

bool is_inside(const Piece& piece, const std::string& element) {
    return std::find(piece.inside.begin(), piece.inside.end(), element) != piece.inside.end();
}

bool is_shown(const Piece& piece) {
    return !piece.is_tag && !is_inside(piece, "style") && !is_inside(piece, "script");
}

std::string resolved(std::string text) {
    for (const auto& [entity, character] :
         {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&quot;", "\""}, std::pair{"&amp;", "&"}}) {
        for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
            text.replace(at, std::string(entity).size(), character);
    }
    return text;
}

int significant_digits(const std::string& mantissa) {
    const auto first = mantissa.find_first_of("123456789");
    if (first == std::string::npos) return 0;
    return static_cast<int>(
        std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(), ::isdigit));
}

void check_links(const std::vector<Piece>& pieces) {
    std::set<std::string> ids, sections;
    for (const Piece& piece : pieces) {
        const auto id = piece.tag.attributes.find("id");
        if (id == piece.tag.attributes.end()) continue;
        INFO(id->second);
        CHECK(ids.insert(id->second).second);
        if (piece.tag.name == "section") sections.insert(id->second);
    }
    std::set<std::string> listed;
    for (const Piece& piece : pieces) {
        for (const char* const name : {"href", "src"}) {
            const auto link = piece.tag.attributes.find(name);
            if (link == piece.tag.attributes.end()) continue;
            INFO(link->second);
            CHECK(link->second.find(':') == std::string::npos);
            if (!link->second.starts_with('#')) continue;
            CHECK(ids.contains(link->second.substr(1)));
            if (is_inside(piece, "nav")) listed.insert(link->second.substr(1));
        }
        const auto labelled = piece.tag.attributes.find("aria-labelledby");
        if (labelled != piece.tag.attributes.end()) CHECK(ids.contains(labelled->second));
    }
    CHECK(listed == (sections.size() > 3 ? sections : std::set<std::string>()));
}

void check_commands(const std::vector<Piece>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        if (!piece.is_tag || piece.tag.closes || piece.tag.name != "code") continue;
        CHECK(is_inside(piece, "details"));
        REQUIRE(i + 3 < pieces.size());  // the command, the end of it, the button
        INFO(pieces[i + 1].text);
        const Tag& button = pieces[i + 3].tag;
        REQUIRE(button.name == "button");
        CHECK(button.attributes.at("type") == "button");
        CHECK(button.attributes.at("class") == "copy");
        CHECK(button.attributes.at("aria-label").size() > std::string("Copy the command: ").size());
    }
}

void check_numbers(const std::vector<Piece>& pieces) {
    static const std::regex number("(^|[^A-Za-z0-9_.-])-?([0-9]+(\\.[0-9]+)?)(e[-+]?[0-9]+)?(?![A-Za-z0-9_.-])");
    static const std::regex negative_zero("(^|[^A-Za-z0-9_.)-])-0(\\.0*)?(?![0-9.e-])");
    for (const Piece& piece : pieces) {
        if (!is_shown(piece) || is_inside(piece, "code")) continue;
        const std::string text = resolved(piece.text);
        INFO(text);
        CHECK(!std::regex_search(text, negative_zero));
        if (!is_inside(piece, "table")) continue;
        for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
            CHECK(significant_digits((*i)[2]) <= 5);
    }
}

}  // namespace

void check_page(const std::string& page) {
    CHECK(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    for (const char* const outside : {"url(", "@import", "http:", "https:", "//cdn"}) {
        INFO(outside);
        CHECK(page.find(outside) == std::string::npos);
    }
    const std::vector<Piece> pieces = pieces_of(page);
    bool titled = false;
    static const std::regex bare("&(?!(amp|lt|gt|quot);)");
    for (const Piece& piece : pieces) {
        if (!is_shown(piece)) continue;
        titled |= is_inside(piece, "title");
        CHECK(piece.text.find('>') == std::string::npos);
        CHECK(!std::regex_search(piece.text, bare));
    }
    CHECK(titled);
    check_links(pieces);
    check_commands(pieces);
    check_numbers(pieces);
}

std::vector<std::string> texts_of(const std::string& page) {
    std::vector<std::string> texts;
    for (const Piece& piece : pieces_of(page)) {
        if (is_shown(piece) && !is_inside(piece, "code")) texts.push_back(resolved(piece.text));
    }
    return texts;
}

}  // namespace pushfactor::tests
