#include "apps/lab/anatomy_command.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/anatomy_set.h"
#include "engine/io/set_description.h"

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
)";

Result<QJsonObject> describeAnatomy(const QStringList& arguments)
{
    const QString verb = arguments.value(0);
    const bool import = verb == QStringLiteral("import");
    if (arguments.size() != 2 || (!import && verb != QStringLiteral("list")))
        return fail(Errc::OutOfRange, "anatomy needs \"import DIR\" or \"list DIR\".");
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

} // namespace

Command anatomyCommand() { return {"anatomy", kAnatomyHelp, describeAnatomy}; }

} // namespace carina::lab
