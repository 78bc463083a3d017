#include "apps/lab/intubation/trial_patient.h"

#include "engine/lungs/mechanics/ventilation.h"
#include "engine/session/respiration/patient_run.h"

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kOnOxygen = 180s; ///< before the motion
constexpr Duration kAsleep = 60s;
constexpr Duration kReadEvery = 1s;

// Per kilogram.
constexpr double kPropofol_mg = 2.0;
constexpr double kFentanyl_mg = 0.002;
constexpr double kRocuronium_mg = 0.9;
constexpr double kTidal_ml = 7.0;

HandBag bagOf(const PatientBuild& build)
{
    constexpr double kGrownBreaths_perMin = 12.0;
    constexpr double kChildBreaths_perMin = 20.0;
    constexpr double kGrown_years = 12.0;
    return {
        perMinute(build.ageInYears < kGrown_years ? kChildBreaths_perMin : kGrownBreaths_perMin),
        millilitres(kTidal_ml * lungWeight(build))};
}

void induce(RespirationTimeline& patient, const PatientBuild& build)
{
    patient.setBuild(kTrialStart - kOnOxygen, build);
    patient.setGas(kTrialStart - kOnOxygen, {.inspiredOxygen = 1.0, .maskHeld = true});
    patient.setRunning(kTrialStart - kOnOxygen, true);
    const SessionTime asleep = kTrialStart - kAsleep;
    patient.give(asleep, {DrugKind::Fentanyl, kFentanyl_mg * build.weightInKilograms});
    patient.give(asleep, {DrugKind::Propofol, kPropofol_mg * lungWeight(build)});
    patient.give(asleep, {DrugKind::Rocuronium, kRocuronium_mg * lungWeight(build)});
    patient.setBag(asleep, bagOf(build));
    patient.setBag(kTrialStart, {});
    patient.setGas(kTrialStart, {.inspiredOxygen = 1.0, .maskHeld = false});
}

void follow(RespirationTimeline& patient, const PatientBuild& build, const MotionCommand& command)
{
    const SessionTime at = kTrialStart + command.at;
    switch (command.act) {
    case MotionAct::CuffInflated:
        return patient.setCuff(at, true);
    case MotionAct::CuffDeflated:
        return patient.setCuff(at, false);
    case MotionAct::StyletOut:
        return patient.drawStylet(at);
    case MotionAct::BreathsBegin:
        return patient.setBag(at, bagOf(build));
    case MotionAct::BreathsEnd:
        return patient.setBag(at, {});
    }
}

} // namespace

std::vector<VitalsReading> patientOf(const IntubationSubject& subject,
                                     const WatchedIntubation& watched, SessionTime until)
{
    RespirationTimeline patient;
    induce(patient, subject.build);
    for (const MotionCommand& command : watched.commands)
        follow(patient, subject.build, command);
    for (const NotedStep& step : watched.noted)
        patient.noteIntubation(step.effect, step.event, subject.innerDiameter);
    PatientRun run{patient, kTrialStart - kOnOxygen};
    std::vector<VitalsReading> readings;
    for (SessionTime t = kTrialStart - kOnOxygen; t <= until; t += kReadEvery) {
        run.advanceTo(patient, t);
        if (t >= kTrialStart)
            readings.push_back({t, run.vitals()});
    }
    return readings;
}

} // namespace carina::lab
