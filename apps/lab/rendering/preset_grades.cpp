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

/// One preset after another.
std::vector<ScopeShot> shotsOfDraws(const std::vector<CountedPreset>& presets,
                                    const GradeOrder& order)
{
    std::mt19937 random{order.seed};
    std::vector<ScopeShot> shots;
    for (const CountedPreset& counted : presets)
        for (int draw = 0; draw < order.draws; ++draw)
            shots.push_back({.events = drawnFrom(*counted.preset, random),
                             .quality = PictureQuality::Quick}); // only its ids are looked at
    return shots;
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
    return {{render_grades_key::kPreset, QString::fromUtf8(name.data(), qsizetype(name.size()))},
            {render_grades_key::kNamedGrade, counted.preset->grade},
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
    const std::vector<ScopeShot> shots = shotsOfDraws(presets, order);
    for (const ScopeShot& shot : shots)
        if (const auto shown = canShowAll(*laryngoscopy, shot.events); !shown)
            return tl::unexpected(shown.error());
    const auto take = [&](const DrawnShot& drawn) -> Result<void> {
        presets[drawn.number / std::size_t(order.draws)].count(drawn.seen.grade);
        return {};
    };
    return drawShots(**patient, *laryngoscopy, order.way, shots, take).map([&] {
        QJsonArray counted;
        bool isAcceptable = true;
        for (const CountedPreset& preset : presets) {
            counted.append(describe(preset));
            isAcceptable = isAcceptable && preset.shareRight() >= kRightGrades;
        }
        return QJsonObject{
            {render_grades_key::kSchema, QLatin1StringView{render_grades_key::kSchema.help}},
            {render_grades_key::kAnatomy, QString::fromStdString((*patient)->name())},
            {render_grades_key::kBlade, bladeName(order.way.blade)},
            {render_grades_key::kFrom, eyeName(order.way.eye)},
            {render_grades_key::kWidth, order.way.size.width()},
            {render_grades_key::kHeight, order.way.size.height()},
            {render_grades_key::kLift, inMillimetres(kUsualLift)},
            {render_grades_key::kSeed, qint64(order.seed)},
            {render_grades_key::kPresets, counted},
            {kAcceptable, isAcceptable}};
    });
}

} // namespace carina::lab
