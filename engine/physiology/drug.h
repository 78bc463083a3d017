#pragma once

#include <array>
#include <cstdint>

namespace carina
{

/// The drugs that an intubation needs.
enum class DrugKind : std::uint8_t {
    Propofol,      ///< induction
    Ketamine,      ///< induction that keeps breathing and blood pressure
    Fentanyl,      ///< against the response to laryngoscopy; slows breathing
    Rocuronium,    ///< relaxant
    Suxamethonium, ///< relaxant, short
    Sugammadex,    ///< reverses rocuronium
    Ephedrine,     ///< raises pressure and heart rate
};
inline constexpr std::array kDrugKinds{
    DrugKind::Propofol,      DrugKind::Ketamine,   DrugKind::Fentanyl, DrugKind::Rocuronium,
    DrugKind::Suxamethonium, DrugKind::Sugammadex, DrugKind::Ephedrine};

/// One dose into a vein.
struct DrugDose {
    DrugKind kind = DrugKind::Propofol;
    double milligrams = 0.0;

    friend bool operator==(const DrugDose&, const DrugDose&) = default;
};

} // namespace carina
