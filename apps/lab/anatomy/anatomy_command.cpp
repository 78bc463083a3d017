#include "apps/lab/anatomy/anatomy_command.h"

#include "apps/lab/anatomy/comparison_report.h"
#include "apps/lab/command/patient_options.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/anatomy_set/anatomy_set.h"
#include "engine/io/anatomy_set/set_description.h"

#include <QCommandLineParser>

namespace carina::lab
{
namespace
{

constexpr std::string_view kAnatomyHelp =
    R"(anatomy import DIR | list DIR
    Describes the patient that a folder of surfaces (OBJ, PLY, STL, glTF, GLB) is read as. `import`
    reads the files, whatever the cache holds; `list` takes the cached set where nothing has changed.
    Nothing is written into DIR.
    schema            "carina.anatomy/1"
    name              of the folder
    content_hash      SHA-256 over the names and bytes of the files
    unit_mm           millimetres in one unit of the files
    axes              where +x, +y and +z of the files point, such as "left"
    parts             one object for each surface:
      name            in the file
      role            "trachea", "right_upper_lobe" ...; "other" where it was not recognised
      concept_id      of the Foundational Model of Anatomy; empty where unknown
      triangles       of the finest level of detail
      levels          of detail
      closed          whether it encloses a volume
      volume_ml       where closed
    lungs             "right_ml" and "left_ml", sums over lobes or whole lungs; null without
    triangles         of all parts at their finest
    landmarks_mm      "incisors", "glottis" and "carina" as [x, y, z] in the anatomy frame (origin at
                      the carina, +x left, +y posterior, +z superior); null without a trachea
    attributions      lines about licence and copyright to show with the set
    faults            "file" and "fault" of each file that could not be used
    left_out          surfaces given twice, and whole lungs beside their lobes
    import_s          seconds until the set was there
    from_cache        whether the files were not read anew
    cache             the file that keeps the set; null where it could not be written
anatomy compare [--set DIR] [--patient WHO]
    Makes a patient and looks for faults in it. With --set it is made with its mouth shut and
    measured, and so is the patient in DIR: how far the two are apart once the set is scaled about
    its carina, head and airway by the distance from the vocal cords to the carina, the chest by the
    cube root of the volume of the lungs.
    schema            "carina.anatomy-compare/1"
    patient           the words for it: "adult" where nothing is said; as in `breathe`
    generate_s        seconds it took to make
    triangles         of all its parts at their finest
    self_intersections  "part", "level" and "pairs" of triangles of each surface that runs through
                      itself
    and with --set
    airway_scale, chest_scale
    figures           "name" with its unit, "generated", "set" (scaled), "deviation" as difference or,
                      where "relative", as share of the set's, "limit" and whether it is "met"
    organs            "to_set_mm", the mean distance of the generated surface from the set's,
                      "from_set_mm" back, and "mean_mm" of both, or of the first where "one_way": the
                      bronchi of a set go on where those of the patient end. At most 6 mm.
    not_in_set, not_in_patient   organs that only the other has
    met, unmet        whether all is met, and what is not, one line for each
)";

Result<QJsonObject> describeSetOf(const QStringList& arguments)
{
    const QString verb = arguments.value(0);
    const bool import = verb == QStringLiteral("import");
    if (arguments.size() != 2 || (!import && verb != QStringLiteral("list")))
        return fail(Errc::OutOfRange, "anatomy needs \"import DIR\", \"list DIR\" or \"compare\".");
    const auto begin = monotonicNow();
    const auto loaded = loadAnatomySet(arguments[1].toStdString(), AnatomyCache::defaultFolder(),
                                       {}, import ? CacheUse::Renewed : CacheUse::Allowed);
    if (!loaded)
        return tl::unexpected(loaded.error());
    const Duration time = monotonicNow() - begin;
    QJsonObject object = describeSet(loaded->set);
    object.insert(QStringLiteral("import_s"), toSeconds(time));
    object.insert(QStringLiteral("from_cache"), loaded->fromCache);
    object.insert(QStringLiteral("cache"),
                  loaded->cacheFault ? QJsonValue{QJsonValue::Null}
                                     : QString::fromStdString(loaded->cacheFile.string()));
    return object;
}

/// Which patient to make, and which set to hold it against.
struct CompareOptions {
    PatientParameters patient;
    QString words; ///< for the patient
    QString set;   ///< empty for none
};

Result<CompareOptions> compareOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("set"), {}, QStringLiteral("DIR")});
    parser.addOption(
        {QStringLiteral("patient"), {}, QStringLiteral("WHO"), QStringLiteral("adult")});
    const bool parsed = parser.parse(arguments); // the verb stands where a program's name would
    if (!parsed || !parser.positionalArguments().isEmpty())
        return fail(Errc::OutOfRange, "anatomy compare takes [--set DIR] [--patient WHO].");
    return figuresOption(parser, "anatomy compare", BuiltinPatient::Adult)
        .map([&](const PatientParameters& patient) {
            return CompareOptions{patient, parser.value(QStringLiteral("patient")),
                                  parser.value(QStringLiteral("set"))};
        });
}

Result<QJsonObject> reportOn(const Anatomy& patient, const QString& set)
{
    if (set.isEmpty())
        return QJsonObject{
            {QStringLiteral("self_intersections"), listOf(selfIntersectionsOf(patient))}};
    const auto loaded = loadAnatomySet(set.toStdString(), AnatomyCache::defaultFolder());
    if (!loaded)
        return tl::unexpected(loaded.error());
    return compareAnatomy(patient, loaded->set.anatomy).map(reportOf);
}

Result<QJsonObject> comparePatient(const QStringList& arguments)
{
    const auto options = compareOptions(arguments);
    if (!options)
        return tl::unexpected(options.error());
    const auto begin = monotonicNow();
    const auto patient = patientFor(options->patient,
                                    options->set.isEmpty() ? Posture::Laryngoscopy : Posture::Rest);
    if (!patient)
        return tl::unexpected(patient.error());
    const Duration time = monotonicNow() - begin;
    auto report = reportOn(*patient, options->set);
    if (!report)
        return report;
    qint64 triangles = 0;
    for (const AnatomyPart& part : patient->parts)
        triangles += qint64(part.levels.front().triangles.size());
    report->insert(QStringLiteral("schema"), QStringLiteral("carina.anatomy-compare/1"));
    report->insert(QStringLiteral("patient"), options->words);
    report->insert(QStringLiteral("generate_s"), toSeconds(time));
    report->insert(QStringLiteral("triangles"), triangles);
    return report;
}

Result<QJsonObject> runAnatomy(const QStringList& arguments)
{
    return arguments.value(0) == QStringLiteral("compare") ? comparePatient(arguments)
                                                           : describeSetOf(arguments);
}

} // namespace

Command anatomyCommand() { return {"anatomy", kAnatomyHelp, runAnatomy}; }

} // namespace carina::lab
