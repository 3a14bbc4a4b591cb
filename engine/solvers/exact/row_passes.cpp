#include "engine/solvers/exact/row_passes.h"

#include "engine/base/instruction_sets.h"

namespace pushfactor::engine::solvers {

namespace {

constexpr int of_body = 6, of_row = 2 * of_body;

}  // namespace

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void push_rows(const RowSpan* spans, int count, const double* units, const double* y, double* v) {
    for (const RowSpan* span = spans; span != spans + count; ++span) {
        Six a(v + of_body * span->a), b(v + of_body * span->b);
        for (int j = span->begin; j < span->end; ++j) {
            const double* const unit = units + of_row * j;
            a.add(y[j], Six(unit));
            b.add(y[j], Six(unit + of_body));
        }
        a.store(v + of_body * span->a);
        b.store(v + of_body * span->b);
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void find_speeds(const RowSpan* spans, int count, const double* units, const double* v, double* speeds) {
    for (const RowSpan* span = spans; span != spans + count; ++span) {
        const Six a(v + of_body * span->a), b(v + of_body * span->b);
        for (int j = span->begin; j < span->end; ++j) {
            const Six on_a(units + of_row * j), on_b(units + of_row * j + of_body);
            const Four upper = on_a.upper * a.upper + on_b.upper * b.upper;
            const Two lower = on_a.lower * a.lower + on_b.lower * b.lower;
            speeds[j] = ((upper[0] + upper[2]) + lower[0]) + ((upper[1] + upper[3]) + lower[1]);
        }
    }
}

}  // namespace pushfactor::engine::solvers
