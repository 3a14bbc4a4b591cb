#include "demos/reports/study.h"

#include "demos/pages/about.h"
#include "demos/pages/job_summary.h"
#include "demos/pages/junit.h"
#include "demos/platform/output_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace pushfactor::demos::reports {

StudyRun::StudyRun(const Study& study, StudyRequest request)
    : study_(study), request_(std::move(request)), machine_(line_of(about_this())) {
    make_folder(request_.folder);
}

bool StudyRun::wants(const std::string& part) const {
    const std::vector<std::string>& parts = request_.parts;
    return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
}

void StudyRun::begin(std::size_t runs, std::size_t done, std::string hint) {
    runs_ = runs;
    done_ = done;
    hint_ = std::move(hint);
    bar_.emplace("report " + study_.name, static_cast<long>(runs));
}

void StudyRun::count_run() {
    bar_->show(static_cast<long>(++done_));
}

void StudyRun::stop_if_interrupted() const {
    demos::stop_if_interrupted(fmt::format("{} of {} runs are in {}{}", done_, runs_, folder().string(), hint_));
}

std::function<void()> StudyRun::check() const {
    return [this] { stop_if_interrupted(); };
}

void StudyRun::write(const std::string& name, const std::string& text) const {
    write_file(folder() / name, text);
}

void StudyRun::write(const std::string& name, const Table& table) const {
    write(name, fmt::format("# {}\n{}", machine_, csv_text(table)));
}

void StudyRun::write(const std::string& headline, std::span<const SuiteVerdict> verdicts) const {
    if (request_.junit) write_file(*request_.junit, junit_xml(verdicts, std::time(nullptr)));
    if (request_.markdown) write_file(*request_.markdown, job_summary(headline, verdicts));
}

void StudyRun::write_page(const std::string& opening) const {
    write("index.html", page_text("Pushfactor: " + study_.title, opening, sections));
}

void make_study(const Study& study, const StudyRequest& request) {
    StudyRun run(study, request);
    study.make(run);
}

std::vector<Study> all_studies() {
    return {error_study(), stability_study(), cost_study(), atlas_study()};
}

}  // namespace pushfactor::demos::reports
