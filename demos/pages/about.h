// What a report was made with and on: times mean nothing without.
#pragma once

#include <string>

namespace pushfactor::demos::reports {

struct About {
    std::string version, compiler, flags;
    std::string cpu;  // empty where the system does not say
    unsigned cores = 0;
};

About about_this();

std::string json_text(const About& about);  // about.json
std::string line_of(const About& about);    // for captions

}  // namespace pushfactor::demos::reports
