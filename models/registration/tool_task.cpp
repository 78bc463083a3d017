#include "models/registration/tool_task.h"

#include "engine/registration/calibration/tube_calibration.h"
#include "engine/registration/error/error_bound.h"
#include "models/errors/error_text.h"
#include "models/site/site_changes.h"
#include "models/station/tool_status.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace carina
{
namespace
{

class ToolWords
{
    Q_DECLARE_TR_FUNCTIONS(ToolTask)

public:
    static QString tubePlace(std::size_t place)
    {
        static const std::array kNames{
            QT_TR_NOOP("rim of the connector, anywhere"),
            QT_TR_NOOP("rim of the connector, a third of the way round"),
            QT_TR_NOOP("rim of the connector, two thirds of the way round"),
            QT_TR_NOOP("wall below the connector, outside of the bend"),
            QT_TR_NOOP("wall a quarter down to the cuff, side of the bend"),
            QT_TR_NOOP("wall half way to the cuff, outside of the bend"),
            QT_TR_NOOP("wall three quarters down to it, side of the bend"),
            QT_TR_NOOP("wall just above the cuff, outside of the bend"),
            QT_TR_NOOP("tip, in the middle of its opening")};
        static_assert(kNames.size() == kTubePlaces.size());
        return tr(kNames[place]);
    }

    static QString bladePlace(std::size_t place)
    {
        static const std::array kNames{
            QT_TR_NOOP("heel of the blade at the handle, your left corner"),
            QT_TR_NOOP("heel of the blade at the handle, your right corner"),
            QT_TR_NOOP("end of the handle, in the middle"),
            QT_TR_NOOP("underside of the blade, half way to its tip"),
            QT_TR_NOOP("tip of the blade, in the middle of its edge")};
        static_assert(kNames.size() == kBladePlaces.size());
        return tr(kNames[place]);
    }

    static QString refused(const Error& error, ToolRole role)
    {
        const QString detail = QString::fromStdString(error.detail);
        switch (error.code) {
        case Errc::DegenerateLandmarks:
            return tr("These touches do not determine the tool: %1. Touch its places as they are "
                      "listed, and a tube where it is bent.")
                .arg(detail);
        case Errc::NoSurfaceFit:
            return role == ToolRole::Tube
                       ? tr("These touches do not fit one tube: %1. Check its outer diameter, undo "
                            "the touch that slipped, or start again.")
                             .arg(detail)
                       : tr("These touches do not fit one laryngoscope: %1. Undo the touch that "
                            "slipped, or start again; left is left as you hold it.")
                             .arg(detail);
        default:
            return errorText(error);
        }
    }

    static QString shape(const SiteTool& tool)
    {
        if (tool.blade)
            return (tool.blade->isCurved() ? tr("Curved blade, %1 mm from heel to tip.")
                                           : tr("Straight blade, %1 mm from heel to tip."))
                .arg(inMillimetres(metres(tool.blade->p_L_tip.norm())), 0, 'f', 0);
        const TubeRest& tube = *tool.tube;
        const QString length = tr("%1 mm from connector to tip, %2 mm thick.")
                                   .arg(inMillimetres(tube.length), 0, 'f', 0)
                                   .arg(inMillimetres(tube.outerDiameter), 0, 'f', 1);
        return length + QLatin1Char(' ')
               + (tube.bends[0] == tube.bends[1]
                      ? tr("At rest it is bent with %1.").arg(bend(tube.bends[0]))
                      : tr("At rest its first half is bent with %1, its second with %2.")
                            .arg(bend(tube.bends[0]), bend(tube.bends[1])));
    }

    static QString error(const SiteTool& tool)
    {
        const double rms = std::sqrt(tool.covariance_N.trace());
        QString text =
            tr("Its tip is known within %1 mm (RMS)").arg(inMillimetres(metres(rms)), 0, 'f', 2);
        if (rms > 0.0)
            text += tr(", in 95 of 100 cases within %1 mm")
                        .arg(inMillimetres(errorBound(tool.covariance_N, tool.degrees)), 0, 'f', 1);
        return text
               + tr(". The %1 touches are off its shape by %2 mm (RMS).")
                     .arg(tool.touches)
                     .arg(inMillimetres(metres(tool.rms)), 0, 'f', 2);
    }

    static QString checked(const SiteTool& tool)
    {
        const TipCheck& tip = tool.check->tip;
        return (tip.isBent()
                    ? tr("Bent, or its markers were moved: at its check the tip was %1 mm from its "
                         "place, and %2 mm are the most that chance explains. Calibrate it again.")
                    : tr("As it was: at its check the tip was %1 mm from its place, within %2 mm."))
            .arg(inMillimetres(tip.error), 0, 'f', 1)
            .arg(inMillimetres(tip.bound), 0, 'f', 1);
    }

private:
    static QString bend(double bend)
    {
        constexpr double kStraightBend = 0.5; // 1/m: 2 m of radius
        return std::abs(bend) < kStraightBend
                   ? tr("no curvature")
                   : tr("a radius of %1 mm").arg(1e3 / std::abs(bend), 0, 'f', 0);
    }
};

} // namespace

ToolTask::ToolTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient)
    : m_editor{editor}, m_watch{watch}, m_outerDiameter{patient.tube().outerDiameter}
{
    for (const ToolRole role : {ToolRole::Tube, ToolRole::Laryngoscope})
        if (m_watch.has(role))
            m_offered.push_back(role);
    if (!m_offered.empty())
        m_chosen = m_offered.front();
    if (const SiteTool* tube = toolOfRole(m_editor.site().tools, ToolRole::Tube))
        m_outerDiameter = tube->tube->outerDiameter;
}

void ToolTask::choose(ToolRole tool)
{
    m_chosen = tool;
    stop();
}

void ToolTask::setOuterDiameter(Length diameter)
{
    m_outerDiameter = diameter;
    if (m_use == Use::Calibrate && !next())
        calibrate();
}

const SiteTool* ToolTask::calibration() const
{
    return toolOfRole(m_editor.site().tools, m_chosen);
}

QString ToolTask::described() const
{
    if (m_offered.empty())
        return ToolWords::tr("This tracker has no tube and no laryngoscope.");
    const SiteTool* tool = calibration();
    if (!tool)
        return ToolWords::tr("Not calibrated: it is drawn as if its markers were at its %1.")
            .arg(m_chosen == ToolRole::Tube ? ToolWords::tr("connector") : ToolWords::tr("heel"));
    QString text = ToolWords::shape(*tool) + QLatin1Char(' ') + ToolWords::error(*tool);
    if (tool->check)
        text += QStringLiteral("\n\n") + ToolWords::checked(*tool);
    return text;
}

QString ToolTask::whyNoTouch() const
{
    if (m_offered.empty())
        return ToolWords::tr("This tracker has no tube and no laryngoscope.");
    if (!m_editor.site().stylus(m_watch.tool()))
        return ToolWords::tr("Find the tip of the stylus first.");
    return {};
}

void ToolTask::beginCalibration() { begin(Use::Calibrate); }

void ToolTask::beginCheck()
{
    if (calibration())
        begin(Use::Check);
}

void ToolTask::begin(Use use)
{
    if (const QString why = whyNoTouch(); !why.isEmpty())
        return m_editor.refuse(why);
    m_use = use;
    m_p_NQ.clear();
    m_editor.confirm({});
}

void ToolTask::stop()
{
    m_use = Use::Nothing;
    m_p_NQ.clear();
    Q_EMIT m_editor.changed();
}

std::size_t ToolTask::placeCount() const
{
    return m_chosen == ToolRole::Tube ? kTubePlaces.size() : kBladePlaces.size();
}

std::vector<ToolTask::PlaceRow> ToolTask::places() const
{
    std::vector<PlaceRow> rows;
    const bool isCalibrating = m_use == Use::Calibrate;
    for (std::size_t i = 0; i < placeCount() && !m_offered.empty(); ++i)
        rows.push_back(
            {.name =
                 m_chosen == ToolRole::Tube ? ToolWords::tubePlace(i) : ToolWords::bladePlace(i),
             .isTouched = isCalibrating ? i < m_p_NQ.size() : calibration() != nullptr,
             .isNext = isCalibrating ? i == m_p_NQ.size() : isChecking() && i + 1 == placeCount()});
    return rows;
}

std::optional<ToolPlace> ToolTask::next() const
{
    if (m_use == Use::Nothing || m_p_NQ.size() == placeCount())
        return std::nullopt;
    const std::size_t place = isChecking() ? placeCount() - 1 : m_p_NQ.size();
    return m_chosen == ToolRole::Tube ? ToolPlace{kTubePlaces[place]}
                                      : ToolPlace{kBladePlaces[place]};
}

QString ToolTask::nextName() const
{
    for (const PlaceRow& row : places())
        if (row.isNext)
            return row.name;
    return {};
}

void ToolTask::take(const StylusTouch& touch)
{
    if (!next())
        return;
    if (isChecking())
        return check(touch.point.p_FQ);
    const QString name = nextName();
    m_p_NQ.push_back(touch.point.p_FQ);
    m_editor.confirm({});
    m_editor.tell(name);
    if (!next())
        calibrate();
}

void ToolTask::undo()
{
    m_p_NQ.pop_back();
    m_editor.confirm({});
}

Result<SiteTool> ToolTask::fitted() const
{
    SiteTool tool{.role = m_chosen, .touches = int(m_p_NQ.size())};
    const auto fill = [&tool](const auto& fit, const RigidTransform& X_NO) {
        tool.X_NO = X_NO;
        tool.rms = fit.rms;
        tool.fle = fit.fle.si;
        tool.degrees = fit.degrees;
        tool.covariance_N = fit.covariance_N;
        return tool;
    };
    if (m_chosen == ToolRole::Tube) {
        std::vector<TubeTouch> touches;
        for (std::size_t i = 0; i < m_p_NQ.size(); ++i)
            touches.push_back({kTubePlaces[i].part, m_p_NQ[i]});
        return calibrateTube(touches, m_outerDiameter).map([&](const TubeCalibration& fit) {
            tool.tube = fit.rest;
            return fill(fit, fit.X_NE);
        });
    }
    std::vector<BladeTouch> touches;
    for (std::size_t i = 0; i < m_p_NQ.size(); ++i)
        touches.push_back({kBladePlaces[i], m_p_NQ[i]});
    return calibrateBlade(touches).map([&](const BladeCalibration& fit) {
        tool.blade = fit.shape;
        return fill(fit, fit.X_NL);
    });
}

void ToolTask::calibrate()
{
    auto tool = fitted();
    if (!tool)
        return m_editor.refuse(ToolWords::refused(tool.error(), m_chosen));
    tool->tool = m_watch.nameOf(m_chosen);
    tool->calibratedAt = m_editor.now();
    tool->operatorName = m_editor.site().operatorName;
    if (!m_editor.become(withTool(m_editor.site(), *std::move(tool))))
        return;
    stop();
    m_editor.tell(ToolWords::tr("The tool is calibrated"));
}

void ToolTask::check(const Vec3& p_NQ)
{
    const SiteTool& tool = *calibration();
    const SiteToolCheck check{
        checkTip(tool.p_NQ_tip(), tool.covariance_N, metres(tool.fle), tool.degrees, p_NQ),
        m_editor.now()};
    if (!m_editor.become(withToolCheck(m_editor.site(), m_chosen, check)))
        return;
    stop();
    m_editor.tell(check.tip.isBent() ? ToolWords::tr("The tool is bent")
                                     : ToolWords::tr("The tool is as it was"));
}

SiteTask ToolTask::task() const
{
    if (m_offered.empty())
        return {.state = TaskState::Done, .why = whyNoTouch()};
    for (const SiteTool& tool : m_editor.site().tools)
        if (const QString why = whyStale(tool); !why.isEmpty())
            return {.state = TaskState::Stale, .why = why};
    std::size_t calibrated = 0;
    for (const ToolRole role : m_offered)
        calibrated += toolOfRole(m_editor.site().tools, role) != nullptr;
    if (calibrated == m_offered.size())
        return {.state = TaskState::Done};
    if (calibrated > 0)
        return {
            .state = TaskState::Begun,
            .why = ToolWords::tr("%1 of %2 are calibrated.").arg(calibrated).arg(m_offered.size())};
    return whyNoTouch().isEmpty() ? SiteTask{}
                                  : SiteTask{.state = TaskState::Waits, .why = whyNoTouch()};
}

} // namespace carina
