#include "apps/lab/anatomy/anatomy_dimensions.h"

#include "apps/lab/anatomy/anatomy_page.h"
#include "apps/lab/command/patient_options.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "evaluation/anatomy/measured_dimensions.h"
#include "evaluation/anatomy/published_dimensions.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace carina::lab
{
namespace
{

/// Who is measured where nobody is named.
constexpr std::array kMeasuredPeople{"1y, 75 cm, boy", "6 years, 116 cm, boy", "child", "adult",
                                     "30 years, 162 cm, woman"};

double inHundredths(double value) { return std::round(100.0 * value) / 100.0; }

QJsonObject rowOf(const PublishedDimension& published, const PatientParameters& person,
                  double measured)
{
    const double mean = published.meanFor(person);
    const QJsonValue none{QJsonValue::Null};
    const auto& sd = published.deviation;
    return {
        {anatomy_dimensions_key::kName,
         QString::fromLatin1(published.name.data(), qsizetype(published.name.size()))},
        {anatomy_dimensions_key::kValue, inHundredths(measured)},
        {anatomy_dimensions_key::kPublished, inHundredths(mean)},
        {anatomy_dimensions_key::kDeviation, sd ? QJsonValue{*sd} : none},
        {anatomy_dimensions_key::kZ, sd ? QJsonValue{inHundredths((measured - mean) / *sd)} : none},
        {anatomy_dimensions_key::kSource,
         QString::fromLatin1(published.source.data(), qsizetype(published.source.size()))}};
}

QJsonArray listed(const std::set<std::string>& names)
{
    QJsonArray list;
    for (const std::string& name : names)
        list.append(QString::fromStdString(name));
    return list;
}

/// @param person as it is made
QJsonObject dimensionsReport(const PatientParameters& person, const Anatomy& patient)
{
    QJsonObject measured;
    const std::map<std::string, double> all = measuredDimensions(patient);
    for (const auto& [name, value] : all)
        measured[QString::fromStdString(name)] = inHundredths(value);
    QJsonArray rows;
    std::set<std::string> within;
    std::set<std::string> beyond;
    for (const PublishedDimension& published : publishedDimensions()) {
        const auto found = all.find(std::string{published.name});
        if (found == all.end() || !published.holdsFor(person))
            continue;
        rows.append(rowOf(published, person, found->second));
        if (!published.deviation)
            continue;
        const double off = std::abs(found->second - published.meanFor(person));
        (off <= *published.deviation ? within : beyond).insert(found->first);
    }
    std::erase_if(beyond, [&within](const std::string& name) { return within.contains(name); });
    return {{anatomy_dimensions_key::kPatient, QString::fromStdString(nameOf(person))},
            {anatomy_dimensions_key::kAge, person.ageInYears},
            {anatomy_dimensions_key::kSex,
             person.sex == Sex::Male ? QStringLiteral("male") : QStringLiteral("female")},
            {anatomy_dimensions_key::kMeasured, measured},
            {anatomy_dimensions_key::kDimensions, rows},
            {anatomy_dimensions_key::kWithin, qint64(within.size())},
            {anatomy_dimensions_key::kBeyond, listed(beyond)}};
}

/// With the mouth shut, as people are measured.
Result<QJsonObject> measured(const PatientParameters& person)
{
    return patientFor(person, Posture::Rest).map([&](const Anatomy& patient) {
        return dimensionsReport(person, patient);
    });
}

} // namespace

Result<QJsonObject> measurePatients(const Words& words)
{
    std::vector<Result<PatientParameters>> people;
    if (words.has(kPatient))
        people.push_back(patientOption(words, BuiltinPatient::Adult));
    else
        std::ranges::transform(kMeasuredPeople, std::back_inserter(people), patientFromWords);
    QJsonArray patients;
    for (const auto& person : people) {
        const auto report = person.and_then(measured);
        if (!report)
            return tl::unexpected(report.error());
        patients.append(*report);
    }
    return QJsonObject{
        {anatomy_dimensions_key::kSchema, QLatin1StringView{anatomy_dimensions_key::kSchema.help}},
        {anatomy_dimensions_key::kPatients, patients}};
}

Use dimensionsUse()
{
    return {.lines = {"dimensions [--patient WHO]"},
            .text = "Makes patients with their mouths shut (of 1, 6 and 12 years, a man and a "
                    "woman, unless one is named), measures them on their surfaces, not in the "
                    "formulas that made these, and compares each dimension with what was published "
                    "of people of that age and sex.",
            .options = {kPatient},
            .schema = anatomy_dimensions_key::kSchema,
            .keys = {anatomy_dimensions_key::kPatients, anatomy_dimensions_key::kPatient,
                     anatomy_dimensions_key::kAge, anatomy_dimensions_key::kSex,
                     anatomy_dimensions_key::kMeasured, anatomy_dimensions_key::kDimensions,
                     anatomy_dimensions_key::kName, anatomy_dimensions_key::kValue,
                     anatomy_dimensions_key::kPublished, anatomy_dimensions_key::kDeviation,
                     anatomy_dimensions_key::kZ, anatomy_dimensions_key::kSource,
                     anatomy_dimensions_key::kWithin, anatomy_dimensions_key::kBeyond}};
}

} // namespace carina::lab
