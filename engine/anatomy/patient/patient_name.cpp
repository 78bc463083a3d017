#include "engine/anatomy/patient/patient_name.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// Of what patientFor makes: raised with every change of a shape.
constexpr std::string_view kVersion = "12";

constexpr std::string_view kAsked =
    "a patient is adult, child, or age (newborn to 90 years), height (100 to 210 cm; below six "
    "years less) and man, woman, boy or girl, in whole numbers, such as \"45 years, 182 cm, "
    "woman\" or \"3 months, 60 cm, boy\"; with slim or obese where that is so (\"adult, slim\"), "
    "and airway 245 mm for teeth to carina";
constexpr std::string_view kAirway = "airway ";
constexpr double kGrownUp_years = 18.0;
/// An age is said in months below this one.
constexpr int kMonthsOfSchoolAge = int(12.0 * kSchoolAge_years);

struct NamedSex {
    std::string_view word;
    Sex sex;
};
constexpr std::array kSexes{NamedSex{"man", Sex::Male},  NamedSex{"woman", Sex::Female},
                            NamedSex{"boy", Sex::Male},  NamedSex{"girl", Sex::Female},
                            NamedSex{"male", Sex::Male}, NamedSex{"female", Sex::Female}};

struct NamedHabitus {
    std::string_view word;
    Habitus habitus;
};
constexpr std::array kHabituses{NamedHabitus{"slim", Habitus::Slim},
                                NamedHabitus{"normal", Habitus::Normal},
                                NamedHabitus{"obese", Habitus::Obese}};

std::string inLowerCase(std::string_view words)
{
    std::string lower{words};
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The words of a patient so far.
struct Said {
    std::optional<double> years;
    std::optional<int> centimetres;
    std::optional<Sex> sex;
    std::optional<Habitus> habitus;
    std::optional<int> millimetres; ///< teeth to carina
    std::optional<Sex> usualSex;    ///< of the built-in patient
};

/// Keeps a value that was not said before.
template <class Value> bool keep(std::optional<Value>& said, Value value)
{
    return !std::exchange(said, value).has_value();
}

bool takeFigure(Said& said, std::string_view text)
{
    int figure = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), figure);
    if (error != std::errc{})
        return false;
    const std::string_view unit = trimmed(text.substr(std::size_t(end - text.data())));
    if (unit == "years" || unit == "year" || unit == "y")
        return keep(said.years, double(figure));
    if (unit == "months" || unit == "month" || unit == "mo")
        return figure < kMonthsOfSchoolAge && keep(said.years, figure / 12.0);
    if (unit == "mm")
        return keep(said.millimetres, figure);
    return unit == "cm" && keep(said.centimetres, figure);
}

/// Age, height and sex of a built-in patient.
bool takeBuiltin(Said& said, const PatientParameters& patient)
{
    said.usualSex = patient.sex;
    return keep(said.years, patient.ageInYears)
           && keep(said.centimetres, int(std::lround(0.1 * inMillimetres(patient.height))));
}

bool take(Said& said, std::string_view text)
{
    const auto sex = std::ranges::find(kSexes, text, &NamedSex::word);
    if (sex != kSexes.end())
        return keep(said.sex, sex->sex);
    const auto habitus = std::ranges::find(kHabituses, text, &NamedHabitus::word);
    if (habitus != kHabituses.end())
        return keep(said.habitus, habitus->habitus);
    if (text == "adult")
        return takeBuiltin(said, parametersOf(BuiltinPatient::Adult));
    if (text == "child")
        return takeBuiltin(said, parametersOf(BuiltinPatient::TwelveYears));
    if (text == "newborn")
        return keep(said.years, 0.0);
    if (text.starts_with(kAirway))
        return text.ends_with("mm") && takeFigure(said, trimmed(text.substr(kAirway.size())));
    return takeFigure(said, text);
}

tl::unexpected<Error> notSaid(const std::string& fault)
{
    return fail(Errc::OutOfRange, fault + ": " + std::string{kAsked});
}

std::string_view wordFor(const PatientParameters& p)
{
    const bool isGrownUp = p.ageInYears >= kGrownUp_years;
    if (p.sex == Sex::Male)
        return isGrownUp ? "man" : "boy";
    return isGrownUp ? "woman" : "girl";
}

/// The age in whole months, where it is that of a young child and not in whole years.
std::optional<long> monthsOf(const PatientParameters& p)
{
    const long months = std::lround(12.0 * p.ageInYears);
    const bool isWholeYears = months > 0 && months % 12 == 0;
    return p.ageInYears >= kSchoolAge_years || isWholeYears ? std::nullopt : std::optional{months};
}
std::string wholeYears(const PatientParameters& p)
{
    return std::to_string(std::lround(p.ageInYears));
}
std::string ageInWords(const PatientParameters& p)
{
    if (const auto months = monthsOf(p))
        return *months == 0   ? "newborn"
               : *months == 1 ? "1 month"
                              : std::to_string(*months) + " months";
    const std::string years = wholeYears(p);
    return years == "1" ? "1 year" : years + " years";
}
std::string ageInHash(const PatientParameters& p)
{
    const auto months = monthsOf(p);
    return months ? std::to_string(*months) + "mo-" : wholeYears(p) + "y-";
}
std::string wholeCentimetres(const PatientParameters& p)
{
    return std::to_string(std::lround(0.1 * inMillimetres(p.height)));
}
std::string wholeMillimetres(Length length)
{
    return std::to_string(std::lround(inMillimetres(length)));
}
std::string_view wordOf(Habitus habitus)
{
    return std::ranges::find(kHabituses, habitus, &NamedHabitus::habitus)->word;
}

} // namespace

Result<PatientParameters> parametersFromWords(std::string_view words)
{
    const std::string lower = inLowerCase(words);
    Said said;
    for (std::string_view rest = lower;;) {
        const auto comma = rest.find(',');
        const std::string_view item = trimmed(rest.substr(0, comma));
        if (!take(said, item))
            return notSaid("'" + std::string{item} + "' is not understood there, or too much");
        if (comma == std::string_view::npos)
            break;
        rest.remove_prefix(comma + 1);
    }
    if (!said.sex)
        said.sex = said.usualSex;
    if (!said.years || !said.centimetres || !said.sex)
        return notSaid(!said.years ? "the age is missing"
                       : !said.sex ? "the sex is missing"
                                   : "the height is missing");
    PatientParameters parameters{*said.years,
                                 metres(*said.centimetres / 100.0),
                                 *said.sex,
                                 said.habitus.value_or(Habitus::Normal),
                                 {}};
    if (said.millimetres)
        parameters.teethToCarina = metres(*said.millimetres / 1000.0);
    return parameters;
}

Result<PatientParameters> patientFromWords(std::string_view words)
{
    const auto parameters = parametersFromWords(words);
    if (!parameters)
        return parameters;
    if (const auto dimensions = dimensionsFor(*parameters); !dimensions)
        return tl::unexpected(dimensions.error());
    return parameters;
}

std::string nameOf(const PatientParameters& parameters)
{
    if (parameters == parametersOf(BuiltinPatient::Adult))
        return "Adult";
    std::string name = ageInWords(parameters) + ", " + wholeCentimetres(parameters) + " cm, "
                       + std::string{wordFor(parameters)};
    if (parameters.habitus != Habitus::Normal)
        name += ", " + std::string{wordOf(parameters.habitus)};
    if (parameters.teethToCarina)
        name += ", " + std::string{kAirway} + wholeMillimetres(*parameters.teethToCarina) + " mm";
    return name;
}

std::string madeHash(const PatientParameters& parameters)
{
    const std::string end = '-' + std::string{kVersion};
    if (parameters == parametersOf(BuiltinPatient::Adult))
        return "builtin-adult" + end;
    if (parameters == parametersOf(BuiltinPatient::TwelveYears))
        return "builtin-twelve-years" + end;
    return "builtin-" + ageInHash(parameters) + wholeCentimetres(parameters) + "cm-"
           + (parameters.sex == Sex::Male ? "male-" : "female-")
           + std::string{wordOf(parameters.habitus)}
           + (parameters.teethToCarina ? '-' + wholeMillimetres(*parameters.teethToCarina) + "mm"
                                       : std::string{})
           + end;
}

std::optional<PatientParameters> parametersOfHash(std::string_view contentHash)
{
    for (const BuiltinPatient patient : {BuiltinPatient::Adult, BuiltinPatient::TwelveYears})
        if (contentHash == madeHash(parametersOf(patient)))
            return parametersOf(patient);
    constexpr std::string_view kStart = "builtin-";
    if (!contentHash.starts_with(kStart)
        || contentHash.size() < kStart.size() + kVersion.size() + 1)
        return std::nullopt;
    std::string words{contentHash.substr(kStart.size())};
    words.resize(words.size() - kVersion.size() - 1);
    std::ranges::replace(words, '-', ',');
    const auto parameters = patientFromWords(words);
    // "adult" and other ways to say the same are not hashes.
    return parameters && madeHash(*parameters) == contentHash ? std::optional{*parameters}
                                                              : std::nullopt;
}

} // namespace carina
