#include "apps/lab/figures/paper_values.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

namespace carina::lab
{
namespace
{

/// The last curve is that of the full speed.
const std::vector<double>& fullSpeed(const DriftFigure& figure) { return figure.curves.back().y; }

double meanOf(const DriftFigure& figure)
{
    const auto& y = fullSpeed(figure);
    return std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
}

double greatestOf(const DriftFigure& figure) { return std::ranges::max(fullSpeed(figure)); }
double ofTwo(const DriftFigure& figure) { return fullSpeed(figure).front(); }
double ofSix(const DriftFigure& figure) { return fullSpeed(figure).back(); }

struct Printed {
    int number;
    std::string_view figure;
    std::string_view quantity;
    std::string_view value;
    std::string_view trend;
    double (*measured)(const DriftFigure&);
};

constexpr std::string_view kLine = "linear regression";
constexpr std::array kPrinted{
    Printed{9, "drift-by-action-none", "greatest of an action", "above 210", "third order",
            greatestOf},
    Printed{10, "drift-by-action-event", "mean of the actions", "11", "higher order", meanOf},
    Printed{11, "drift-by-action-asa-adaptive", "mean of the actions", "2.83", "higher order",
            meanOf},
    Printed{12, "drift-by-participants-event", "mean with 2 participants", "", kLine, ofTwo},
    Printed{12, "drift-by-participants-event", "mean with 6 participants", "", kLine, ofSix},
    Printed{13, "drift-by-participants-asa-adaptive", "mean with 2 participants", "2.83", kLine,
            ofTwo},
    Printed{13, "drift-by-participants-asa-adaptive", "mean with 6 participants", "3.17", kLine,
            ofSix},
};

/// The paper's angle is always 2 acos(w), which is the drift for w >= 0 alone.
std::string quantityOf(const Printed& printed, const DriftFigure& figure)
{
    return std::string{figure.isAngleRaw ? "2 acos(w)" : "drift"} + ": "
           + std::string{printed.quantity};
}

} // namespace

std::vector<PaperValue> besidePaper(std::span<const DriftFigure> figures)
{
    std::vector<PaperValue> values;
    for (const Printed& printed : kPrinted) {
        const std::string name = std::string{printed.figure} + "-orientation";
        const auto figure = std::ranges::find(figures, name, &DriftFigure::name);
        if (figure != figures.end())
            values.push_back({printed.number, &*figure, quantityOf(printed, *figure),
                              std::string{printed.value}, printed.measured(*figure),
                              std::string{printed.trend}});
    }
    return values;
}

} // namespace carina::lab
