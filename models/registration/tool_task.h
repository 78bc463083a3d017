#pragma once

#include "models/patient/patient_model.h"
#include "models/registration/stylus_watch.h"
#include "models/site/site_editor.h"
#include "models/site/site_tasks.h"

#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace carina
{

/// A place of a tube or laryngoscope that is touched with the stylus.
using ToolPlace = std::variant<TubeTouchPlace, BladePlace>;

/// Calibrates the tube and the laryngoscope: their places are touched one by one with the tip of
/// the stylus while the tracker sees both, and the last touch is followed by the fit
/// (calibrateTube, calibrateBlade). Later one touch of the tip checks whether the tool is still as
/// it was.
class ToolTask
{
public:
    /// A place, and how far it is.
    struct PlaceRow {
        QString name;
        bool isTouched = false;
        bool isNext = false;
    };

    /// @param patient whose tube is as thick as the real one unless it is set
    /// @pre all outlive this.
    ToolTask(SiteEditor& editor, StylusWatch& watch, const PatientModel& patient);

    /// Which of tube and laryngoscope the tracker has.
    [[nodiscard]] const std::vector<ToolRole>& offered() const { return m_offered; }
    /// The one that this is about. @pre one is offered.
    [[nodiscard]] ToolRole chosen() const { return m_chosen; }
    void choose(ToolRole tool);

    /// Of the tube, as printed on it.
    [[nodiscard]] Length outerDiameter() const { return m_outerDiameter; }
    void setOuterDiameter(Length diameter);

    /// The calibration of the chosen tool; null before there is one.
    [[nodiscard]] const SiteTool* calibration() const;
    /// What it tells, in sentences.
    [[nodiscard]] QString described() const;

    /// One sentence: why no tool can be touched now; empty if one can.
    [[nodiscard]] QString whyNoTouch() const;
    /// Begins with the first place; earlier touches are dropped. The stored calibration stays until
    /// the new one is found. Refused if whyNoTouch() is not empty.
    void beginCalibration();
    /// Waits for one touch of the tip. Refused like beginCalibration, and without a calibration.
    void beginCheck();
    void stop();
    [[nodiscard]] bool isTouching() const { return m_use != Use::Nothing; }
    [[nodiscard]] bool isChecking() const { return m_use == Use::Check; }

    /// The places to touch, in their order.
    [[nodiscard]] std::vector<PlaceRow> places() const;
    /// The place to touch next; std::nullopt while nothing is to be touched.
    [[nodiscard]] std::optional<ToolPlace> next() const;
    [[nodiscard]] QString nextName() const;
    /// Records a touch of next(), in the frame of the tool's markers.
    void take(const StylusTouch& touch);

    [[nodiscard]] bool canUndo() const { return isTouching() && !m_p_NQ.empty(); }
    /// Drops the last touch. @pre canUndo()
    void undo();

    [[nodiscard]] SiteTask task() const;

private:
    enum class Use : std::uint8_t { Nothing, Calibrate, Check };

    [[nodiscard]] std::size_t placeCount() const;
    void begin(Use use);
    void calibrate();
    void check(const Vec3& p_NQ);
    [[nodiscard]] Result<SiteTool> fitted() const;

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    std::vector<ToolRole> m_offered;
    ToolRole m_chosen = ToolRole::Tube;
    Length m_outerDiameter;
    Use m_use = Use::Nothing;
    std::vector<Vec3> m_p_NQ; ///< touched so far
};

} // namespace carina
