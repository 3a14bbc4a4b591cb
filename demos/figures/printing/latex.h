// Figures in LaTeX: what to put into a document, and how to cite.
#pragma once

#include "demos/figures/printing/format.h"

#include <string>

namespace pushfactor::demos {

// Plain text as LaTeX for pdflatex: special characters escaped, powers and Greek letters as mathematics.
std::string latex_text(const std::string& text);

// A figure with caption, citation and label; `file` is a PDF next to the document. Wider than a column of a page in
// two columns: over both.
std::string latex_figure(const std::string& name, const std::string& file, const Print& print,
                         const std::string& caption);

// Entries of BibTeX for the paper and for the program with its version and commit.
std::string bibliography();

}  // namespace pushfactor::demos
