#include "apps/lab/rendering/preset_grades.h"

#include "apps/lab/rendering/render_page.h"
#include "models/airway/airway_presets.h"
#include "models/patient/patient_source.h"

#include <QJsonArray>

#include <map>

namespace carina::lab
{
namespace
{

/// The grades that were seen of a preset.
struct CountedPreset {
    const AirwayPreset* preset = nullptr;
    std::map<CormackLehane, int> grades{};
    int draws = 0;
    int right = 0;

    void count(CormackLehane grade)
    {
        ++grades[grade];
        ++draws;
        right += isNamedFor(*preset, grade) ? 1 : 0;
    }
    [[nodiscard]] double shareRight() const { return draws > 0 ? double(right) / draws : 0.0; }
};

std::vector<CountedPreset> gradedPresets()
{
    std::vector<CountedPreset> all;
    for (const AirwayPreset& preset : airwayPresets())
        if (preset.grade > 0)
            all.push_back({.preset = &preset});
    return all;
}

std::vector<ScopeShot> shotsOfDraws(const AirwayPreset& preset, int draws, std::mt19937& random)
{
    std::vector<ScopeShot> shots;
    for (int draw = 0; draw < draws; ++draw)
        shots.push_back({.events = drawnFrom(preset, random),
                         .head = preset.look.head,
                         .quality = PictureQuality::Quick}); // only its ids are looked at
    return shots;
}

Result<void> countDraws(CountedPreset& counted, const PatientModel& patient,
                        const Laryngoscopy& laryngoscopy, const ScopeWay& way,
                        std::span<const ScopeShot> shots)
{
    for (const ScopeShot& shot : shots)
        if (const auto shown = canShowAll(laryngoscopy, shot.events); !shown)
            return shown;
    const auto take = [&counted](const DrawnShot& drawn) -> Result<void> {
        counted.count(drawn.seen.grade);
        return {};
    };
    return drawShots(patient, laryngoscopy, way, shots, take);
}

QJsonArray describe(const std::vector<SeverityRange>& ranges)
{
    QJsonArray all;
    for (const SeverityRange& range : ranges)
        all.append(
            QJsonObject{{render_grades_key::kEvent, QString::fromLatin1(eventName(range.kind))},
                        {render_grades_key::kLeast, range.least},
                        {render_grades_key::kMost, range.most},
                        {render_grades_key::kSource, QString::fromUtf8(range.source)}});
    return all;
}

QJsonObject describe(const CountedPreset& counted)
{
    QJsonObject grades;
    for (const auto& [grade, count] : counted.grades)
        grades[QString::fromLatin1(gradeName(grade))] = count;
    const std::string_view name = counted.preset->name;
    const GradedLook& look = counted.preset->look;
    return {{render_grades_key::kPreset, QString::fromUtf8(name.data(), qsizetype(name.size()))},
            {render_grades_key::kNamedGrade, counted.preset->grade},
            {render_grades_key::kFrom, eyeName(look.eye)},
            {render_grades_key::kNeckFlexion, inDegrees(look.head.flexion)},
            {render_grades_key::kHeadExtension, inDegrees(look.head.extension)},
            {render_grades_key::kDraws, counted.draws},
            {render_grades_key::kGrades, grades},
            {render_grades_key::kShareRight, counted.shareRight()},
            {render_grades_key::kRanges, describe(counted.preset->ranges)}};
}

} // namespace

Result<QJsonObject> countGrades(Anatomy anatomy, const GradeOrder& order)
{
    const auto patient = patientOf(std::move(anatomy));
    if (!patient)
        return tl::unexpected(patient.error());
    const auto laryngoscopy = Laryngoscopy::of(**patient, bladeOf(order.way.blade));
    if (!laryngoscopy)
        return tl::unexpected(laryngoscopy.error());
    std::vector<CountedPreset> presets = gradedPresets();
    std::mt19937 random{order.seed};
    QJsonArray counted;
    bool isAcceptable = true;
    for (CountedPreset& preset : presets) {
        ScopeWay way = order.way;
        way.eye = preset.preset->look.eye;
        const auto shots = shotsOfDraws(*preset.preset, order.draws, random);
        if (const auto drawn = countDraws(preset, **patient, *laryngoscopy, way, shots); !drawn)
            return tl::unexpected(drawn.error());
        counted.append(describe(preset));
        isAcceptable = isAcceptable && preset.shareRight() >= kRightGrades;
    }
    return QJsonObject{
        {render_grades_key::kSchema, QLatin1StringView{render_grades_key::kSchema.help}},
        {render_grades_key::kAnatomy, QString::fromStdString((*patient)->name())},
        {render_grades_key::kBlade, bladeName(order.way.blade)},
        {render_grades_key::kWidth, order.way.size.width()},
        {render_grades_key::kHeight, order.way.size.height()},
        {render_grades_key::kLift, inMillimetres(kUsualLift)},
        {render_grades_key::kSeed, qint64(order.seed)},
        {render_grades_key::kPresets, counted},
        {kAcceptable, isAcceptable}};
}

} // namespace carina::lab
