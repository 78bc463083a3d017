#include "models/registration/registration_words.h"

#include "models/registration/registration_model.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

class RegistrationWords
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationWords)

public:
    static QString overview(const RegistrationModel& model)
    {
        if (const auto place = model.manikin().next())
            return tr("Touch this place in the manikin's airway and hold still, or skip it: %1.")
                .arg(airwayPlaceName(*place));
        const SiteStep next = model.nextStep();
        if (next == SiteStep::Overview)
            return tr("Everything is done. The session can begin.");
        return tr("Continue with: %1.").arg(stepTitle(next));
    }

    static QString tracker(const RegistrationModel& model)
    {
        if (!model.has(ToolRole::Stylus))
            return tr("This tracker has no stylus, with which the manikin is touched: connect it "
                      "again with a tool of that role, or another tracker.");
        if (model.task(SiteStep::Tracker).state == TaskState::Done)
            return tr("The %1 is in use. Continue with the stylus.").arg(model.trackerName());
        return model.has(ToolRole::Jaw)
                   ? tr("Check that stylus and chin probe are visible, then use this tracker.")
                   : tr("Check that the stylus is visible, then use this tracker. It has no chin "
                        "probe: the patient's jaw will not follow the manikin's.");
    }

    static QString stylus(const RegistrationModel& model)
    {
        const StylusTask& stylus = model.stylus();
        if (stylus.isSpinning())
            return tr("Turn the stylus about its shaft, back and forth, by half a turn or more.");
        if (stylus.isLookingForTip())
            return missing(stylus.pivot().need);
        if (stylus.tip())
            return tr("The tip is known. Continue, or find it again if the stylus was bent.");
        return tr("Find the tip by pivot calibration: put it into a divot and swing the stylus.");
    }

    static QString landmarks(const RegistrationModel& model)
    {
        if (const auto chosen = model.landmarkTask().chosen())
            return tr("Click on the model to place this landmark: %1.")
                .arg(model.landmarks()[*chosen].name);
        return tr("Use these landmarks, or choose one in the list to move it.");
    }

    static QString touch(const RegistrationModel& model)
    {
        if (!model.stylus().tip())
            return tr("Find the tip of the stylus first.");
        if (model.touching().isRelaying())
            return tr("Touch any three landmarks of the manikin in its new place, and a fourth if "
                      "the program asks for it.");
        if (const auto next = model.nextLandmark())
            return tr("Keep the manikin's mouth shut. Touch this place and hold still: %1.")
                .arg(model.landmarks()[*next].name);
        if (isNotGood(model.site()))
            return tr("The registration is not good enough: choose a landmark to touch it again.");
        return tr(
            "All landmarks are touched. Continue with the fit, or choose one to touch again.");
    }

    static QString fit(const RegistrationModel& model)
    {
        if (model.fitting().isSwabbing())
            return tr(
                "Slide the tip back and forth over this surface, then refine: %n points so far.",
                nullptr, int(model.fitting().swabPoints()));
        const SiteTask task = model.task(SiteStep::Fit);
        if (task.state == TaskState::Done)
            return tr("Fitted: fiducial registration error %1 mm (RMS). It says little about the "
                      "airway: see the expected errors there.")
                .arg(inMillimetres(metres(model.site().registration->rms)), 0, 'f', 1);
        return task.why.isEmpty() || task.state == TaskState::Stale
                   ? tr("Close the manikin's mouth, then fit the patient to the landmarks.")
                   : task.why;
    }

    static QString verify(const RegistrationModel& model)
    {
        const SiteTask task = model.task(SiteStep::Verify);
        if (task.state == TaskState::Waits)
            return task.why;
        if (!model.verifying().canJudge())
            return tr("Fit the patient to the landmarks again first.");
        if (isNotGood(model.site()))
            return tr(
                "The registration is recorded as not good enough. Touch the landmarks again.");
        if (const auto next = model.verifying().next())
            return tr("Touch this point, which was not used in the fit: %1. Or click on the model "
                      "to add a point.")
                .arg(model.verifying().points()[*next].name);
        if (model.verifying().isRecorded())
            return task.state == TaskState::Done
                       ? tr("The registration is recorded as good. Continue with the overview.")
                       : task.why;
        if (model.site().operatorName.empty())
            return tr("All points are checked. Enter your name beside the verdict, then record "
                      "it.");
        return tr("All points are checked. Record the verdict.");
    }

    static QString tools(const RegistrationModel& model)
    {
        const ToolTask& tools = model.toolTask();
        if (const QString why = tools.whyNoTouch(); !why.isEmpty())
            return why;
        const QString name = toolRoleName(tools.chosen());
        if (tools.next())
            return tr("%1: touch this place with the stylus and hold still: %2.")
                .arg(name, tools.nextName());
        if (tools.isTouching())
            return tr("%1: undo the last touch and make it again, or start again.").arg(name);
        return tools.calibration()
                   ? tr("%1: calibrated. Touch its tip to check it, or calibrate it again.")
                         .arg(name)
                   : tr("%1: calibrate it by touching its places with the stylus.").arg(name);
    }

private:
    static QString missing(PivotNeed need)
    {
        switch (need) {
        case PivotNeed::Swing:
            return tr(
                "Put the tip into a divot and swing the stylus: calibration starts automatically.");
        case PivotNeed::Motion:
            return tr("Swing it further, by 30 degrees to every side.");
        case PivotNeed::Directions:
            return tr("Swing it in the other direction too: at right angles to the motion so far.");
        case PivotNeed::Stillness:
            return tr("The tip slips: keep it in the divot.");
        case PivotNeed::Poses:
            return tr("Good. Keep swinging until the bar is full.");
        case PivotNeed::Nothing:
            break;
        }
        return {};
    }
};

} // namespace

QString registrationInstruction(const RegistrationModel& model)
{
    switch (model.step()) {
    case SiteStep::Overview:
        return RegistrationWords::overview(model);
    case SiteStep::Tracker:
        return RegistrationWords::tracker(model);
    case SiteStep::Stylus:
        return RegistrationWords::stylus(model);
    case SiteStep::Landmarks:
        return RegistrationWords::landmarks(model);
    case SiteStep::Touch:
        return RegistrationWords::touch(model);
    case SiteStep::Fit:
        return RegistrationWords::fit(model);
    case SiteStep::Verify:
        return RegistrationWords::verify(model);
    case SiteStep::Tools:
        return RegistrationWords::tools(model);
    }
    return {};
}

} // namespace carina
