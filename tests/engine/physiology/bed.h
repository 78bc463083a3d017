#pragma once

#include "engine/physiology/body_fold.h"

#include <cmath>

namespace carina::test
{

inline constexpr PatientBuild kLeanAdult{metres(1.75), 77.0, 30.0, Sex::Male};
inline constexpr PatientBuild kTwelve{metres(1.50), 40.0, 12.0, Sex::Male};
inline constexpr PatientBuild kObese{metres(1.75), 127.0, 45.0, Sex::Male};
inline constexpr PatientBuild kInfant{metres(0.75), 9.3, 1.0, Sex::Female};
inline constexpr PatientBuild kFourYears{metres(1.03), 16.5, 4.0, Sex::Male};
inline constexpr PatientBuild kNewborn{metres(0.50), 3.3, 0.0, Sex::Female};

/// A patient with mechanics and body, driven together; change `lungs` and `care`, then apply().
class Bed
{
public:
    explicit Bed(const PatientBuild& build)
        : lungs{restingOf(build)}, care{careOf(build)}, breathing{lungs}, body{care}
    {
    }

    void apply()
    {
        breathing.set(lungs);
        body.set(care);
    }

    void step()
    {
        for (int i = 0; i < kRespiratoryStepsPerBodyStep; ++i)
            breathing.step();
        body.step(breathing);
    }

    void run(double seconds)
    {
        runWhile(seconds, [] { return true; });
    }

    /// @returns the seconds after which goesOn() was no longer true; all of them if it stayed true
    template <class GoesOn> double runWhile(double seconds, GoesOn goesOn)
    {
        const long steps = std::lround(seconds / kBodyStep);
        for (long i = 0; i < steps; ++i) {
            step();
            if (!goesOn())
                return double(i + 1) * kBodyStep;
        }
        return seconds;
    }

    void holdMask(double oxygen)
    {
        care.gas = {oxygen, true, true};
        apply();
    }

    /// A tube with a bag or without, and no mask.
    void intubate(TubeSeat seat, double oxygen)
    {
        lungs.tube = millimetres(8.0);
        care.tube = {seat, millimetres(8.0)};
        care.gas = {oxygen, false, true};
        apply();
    }

    void stopBreathing()
    {
        lungs.ownBreathing = 0.0;
        apply();
    }

    void squeezeBag(double perMin, double tidalVolume_ml)
    {
        lungs.bag = {perMinute(perMin), millilitres(tidalVolume_ml)};
        apply();
    }

    void letLungsSuffer(const LungConditions& conditions)
    {
        lungs.conditions = care.conditions = conditions;
        apply();
    }

    [[nodiscard]] double saturation() const { return body.vitals().arterialSaturation; }
    [[nodiscard]] double endTidal_mmHg() const
    {
        return inMmHg(body.vitals().endTidalCO2.value_or(Pressure{}));
    }
    [[nodiscard]] double exhaled_mmHg() const
    {
        return inMmHg(body.vitals().exhaledCO2.value_or(Pressure{}));
    }
    [[nodiscard]] double heartRate_perMin() const { return inPerMinute(body.vitals().heartRate); }
    [[nodiscard]] double mean_mmHg() const { return inMmHg(body.vitals().mean); }

    RespiratorySettings lungs;
    BodySettings care;
    RespiratoryFold breathing;
    BodyFold body;

private:
    [[nodiscard]] static BodySettings careOf(const PatientBuild& build)
    {
        BodySettings settings;
        settings.build = build;
        return settings;
    }

    [[nodiscard]] static RespiratorySettings restingOf(const PatientBuild& build)
    {
        RespiratorySettings settings;
        settings.build = build;
        settings.pattern = restingPattern(build);
        return settings;
    }
};

} // namespace carina::test
