// Program, compiler and machine of a report, without which times mean nothing.
#pragma once

#include <string>

namespace pushfactor::demos::reports {

struct About {
    std::string version, compiler, flags;
    std::string cpu;  // model name; empty if unknown
    unsigned cores = 0;
};

About about_this();

std::string about_json(const About& about);  // about.json
std::string line_of(const About& about);     // for captions

}  // namespace pushfactor::demos::reports
