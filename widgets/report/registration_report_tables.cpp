#include "widgets/report/registration_report_tables.h"

#include <QCoreApplication>

#include <cmath>

namespace carina
{
namespace
{

class RegistrationReportTables
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationReport)

public:
    static QString textOf(std::optional<double> value_mm)
    {
        if (!value_mm || !std::isfinite(*value_mm))
            return QStringLiteral("—");
        // The unit goes where its number goes.
        return tr("%1 mm").arg(*value_mm, 0, 'f', 2).replace(QLatin1Char{' '}, QChar::Nbsp);
    }

    static BarTable checked(const RegistrationReport& report)
    {
        BarTable table{.columns = {{.header = tr("Point"), .width_mm = 52.0},
                                   {.header = tr("Measured"), .width_mm = 21.0, .isNumber = true},
                                   {.header = tr("Bound"), .width_mm = 21.0, .isNumber = true},
                                   {.header = tr("Within"), .width_mm = 22.0}},
                       .barLabel = tr("Measured error"),
                       .markLabel = tr("Expected bound"),
                       .unit = tr("mm"),
                       .rows = {}};
        for (const auto& point : report.checked)
            table.rows.push_back(
                {.cells = {point.name, textOf(point.error_mm), textOf(point.bound_mm),
                           point.isWithin() ? tr("✓ yes") : tr("▲ no")},
                 .bar = point.error_mm,
                 .mark = point.bound_mm});
        return table;
    }

    static BarTable targets(const RegistrationReport& report)
    {
        BarTable table{
            .columns = {{.header = tr("Target"), .width_mm = 40.0},
                        {.header = tr("Root mean square"), .width_mm = 21.0, .isNumber = true},
                        {.header = tr("95 % bound"), .width_mm = 21.0, .isNumber = true},
                        {.header = tr("Weakest direction"), .width_mm = 34.0}},
            .barLabel = tr("TRE, root mean square"),
            .markLabel = tr("95 % bound"),
            .unit = tr("mm"),
            .rows = {}};
        for (const auto& target : report.targets)
            table.rows.push_back({.cells = {target.name, textOf(target.rms_mm),
                                            textOf(target.bound_mm), target.weakestDirection},
                                  .bar = target.rms_mm,
                                  .mark = target.bound_mm});
        return table;
    }

    static BarTable landmarks(const RegistrationReport& report)
    {
        BarTable table{.columns = {{.header = tr("Landmark"), .width_mm = 36.0},
                                   {.header = tr("Spread"), .width_mm = 21.0, .isNumber = true},
                                   {.header = tr("Residual"), .width_mm = 21.0, .isNumber = true},
                                   {.header = tr("Expected"), .width_mm = 21.0, .isNumber = true},
                                   {.header = tr("Left out"), .width_mm = 21.0, .isNumber = true}},
                       .barLabel = tr("Residual"),
                       .markLabel = tr("Expected residual"),
                       .unit = tr("mm"),
                       .rows = {}};
        for (const auto& landmark : report.landmarks)
            table.rows.push_back(
                {.cells = {landmark.name, textOf(landmark.spread_mm), textOf(landmark.residual_mm),
                           textOf(landmark.expected_mm), textOf(landmark.leftOut_mm)},
                 .bar = landmark.residual_mm,
                 .mark = landmark.expected_mm});
        return table;
    }
};

} // namespace

QString reportedMillimetres(std::optional<double> value_mm)
{
    return RegistrationReportTables::textOf(value_mm);
}

BarTable tableOfChecked(const RegistrationReport& report)
{
    return RegistrationReportTables::checked(report);
}

BarTable tableOfTargets(const RegistrationReport& report)
{
    return RegistrationReportTables::targets(report);
}

BarTable tableOfLandmarks(const RegistrationReport& report)
{
    return RegistrationReportTables::landmarks(report);
}

} // namespace carina
