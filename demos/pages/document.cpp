#include "demos/pages/document.h"

#include "demos/pages/html.h"
#include "demos/pages/short_numbers.h"
#include "demos/platform/assets.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

namespace pushfactor::demos {

namespace {

std::string asset(const std::string& name) {
    return asset_text(asset_folder("pages") / name);
}

}  // namespace

std::string document(const std::string& title, const std::string& opening, const std::string& body,
                     std::span<const std::string> assets) {
    std::string styles, scripts;
    for (const std::string& name : assets) (name.ends_with(".css") ? styles : scripts) += asset(name);
    return fmt::format(
               "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{0}</title>\n"
               "<style>\n{1}</style>\n</head>\n<body>\n<header>\n<h1>{0}</h1>\n<p>{2}</p>\n</header>\n",
               html::escaped(title), styles, html::escaped(with_short_numbers(opening))) +
           body +
           fmt::format("<p id=\"said\" role=\"status\"></p>\n<script>\n{}</script>\n</body>\n</html>\n", scripts);
}

}  // namespace pushfactor::demos
