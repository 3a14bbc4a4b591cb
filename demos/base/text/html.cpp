#include "demos/base/text/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>

namespace pushfactor::demos::html {

namespace {

bool is_plain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += c == '&'   ? "&amp;"
                  : c == '<' ? "&lt;"
                  : c == '>' ? "&gt;"
                  : c == '"' ? "&quot;"
                             : std::string(1, c);
    }
    return result;
}

std::string anchor(std::string_view name) {
    std::string result(name);
    std::replace_if(result.begin(), result.end(), std::not_fn(is_plain), '-');
    return result;
}

std::string link_to(std::string_view file) {
    std::string result;
    for (const char c : file)
        result +=
            is_plain(c) || c == '/' ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return result;
}

}  // namespace pushfactor::demos::html
