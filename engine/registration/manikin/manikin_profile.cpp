#include "engine/registration/manikin/manikin_profile.h"

namespace carina
{
namespace
{

constexpr const char* kSeed = "Hamza-Lup, Rolland, Hughes: A Distributed Augmented Reality System "
                              "for Medical Training and Simulation, 2004";
constexpr const char* kSeedPlaces = "four on the rib cage as in 2004; which places these were is "
                                    "not published: these are of ours";

std::vector<ManikinProfile> made()
{
    return {
        {.name = "METI Human Patient Simulator, child, as in 2004",
         .note = "Of the adult METI HPS: CT of four patient simulators and two airway trainers "
                 "beside 20 adults: it was the most realistic, with 6 of 19 measures of the upper "
                 "airway in the patients' 95 % interval (Schebesta and others, Anesthesiology 116, "
                 "2012). No publication measures the child's.",
         .landmarks = {"Sternal notch", "Xiphoid process", "Left fifth rib, mid-clavicular line",
                       "Right fifth rib, mid-clavicular line"},
         .landmarksSource = kSeedPlaces,
         .patient = "child",
         .patientSource = kSeed},
        {.name = "Laerdal Airway Management Trainer",
         .note = "CT of 13 manikins beside 47 adults: none matched in all of six measures of the "
                 "upper airway; this one was at least satisfactory (Schalk and others, "
                 "Resuscitation 92, 2015).",
         .patient = "adult",
         .patientSource = "Schalk and others, Resuscitation 92, 2015: compared with adults"},
        {.name = "TruCorp AirSim",
         .note = "An intubation head for a tube of 7 mm and a Macintosh blade of size 3 (Farré and "
                 "others, Simulation in Healthcare 9, 2014).",
         .patient = "adult",
         .patientSource = "Farré and others, Simulation in Healthcare 9, 2014: an adult's tube"},
    };
}

} // namespace

std::span<const ManikinProfile> builtinManikins()
{
    static const std::vector<ManikinProfile> profiles = made();
    return profiles;
}

} // namespace carina
