#include "apps/viewer/patient_option.h"

#include "engine/io/anatomy_set.h"
#include "engine/io/builtin_cache.h"
#include "models/error_text.h"
#include "ui/import_dialog.h"

#include <QCoreApplication>

#include <cstdio>

namespace carina::viewer
{
namespace
{

const QString kAnatomy = QStringLiteral("anatomy");
const QString kPatient = QStringLiteral("patient");

Result<BuiltinPatient> builtinNamed(const QString& name)
{
    if (name == QStringLiteral("adult"))
        return BuiltinPatient::Adult;
    if (name == QStringLiteral("child"))
        return BuiltinPatient::TwelveYears;
    return fail(Errc::WrongOption,
                "--patient takes adult or child, not '" + name.toStdString() + "'");
}

/// Nobody is asked by a program that starts or works by itself.
bool hasPerson(const QCommandLineParser& parser)
{
    const QStringList given = parser.optionNames();
    return !given.contains(QStringLiteral("measure")) && !given.contains(QStringLiteral("journal"))
           && !given.contains(QStringLiteral("start"));
}

/// The set in a folder: from the cache, else while a person looks on, corrects and may stop it.
Result<LoadedSet> setForPerson(const std::filesystem::path& folder)
{
    const std::filesystem::path cache = AnatomyCache::defaultFolder();
    auto cached = loadAnatomySet(folder, cache, [](double) { return false; });
    if (cached || cached.error().code != Errc::Cancelled)
        return cached;
    SetImport import{folder, cache};
    ImportDialog dialog{import};
    dialog.exec();
    return import.takeResult();
}

/// Files that could not be used are told on stderr, and the rest is shown.
Result<Anatomy> importedPatient(const std::filesystem::path& folder, bool forPerson)
{
    auto loaded =
        forPerson ? setForPerson(folder) : loadAnatomySet(folder, AnatomyCache::defaultFolder());
    if (!loaded)
        return tl::unexpected(loaded.error());
    for (const FileFault& fault : loaded->set.faults)
        std::fprintf(stderr, "%s\n", qPrintable(errorText(fault.error)));
    return std::move(loaded->set.anatomy);
}

} // namespace

void addPatientOptions(QCommandLineParser& parser)
{
    parser.addOption(
        {kAnatomy,
         QCoreApplication::translate("Program", "Show the anatomy set in this folder of surfaces."),
         QStringLiteral("DIR")});
    parser.addOption({kPatient,
                      QCoreApplication::translate("Program", "Show a built-in patient: adult, or "
                                                             "child of twelve years."),
                      QStringLiteral("NAME"), QStringLiteral("child")});
}

bool importsPatient(const QCommandLineParser& parser) { return parser.isSet(kAnatomy); }

Result<ChosenPatient> choosePatient(const QCommandLineParser& parser)
{
    const bool imported = importsPatient(parser);
    const auto builtin = imported ? Result<BuiltinPatient>{BuiltinPatient::Adult}
                                  : builtinNamed(parser.value(kPatient));
    if (!builtin)
        return tl::unexpected(builtin.error());
    auto anatomy = imported
                       ? importedPatient(parser.value(kAnatomy).toStdString(), hasPerson(parser))
                       : cachedBuiltinPatient(*builtin, AnatomyCache::defaultFolder());
    if (!anatomy)
        return tl::unexpected(anatomy.error());
    auto model = patientOf(std::move(*anatomy));
    if (!model)
        return tl::unexpected(model.error());
    return ChosenPatient{*std::move(model), dimensionsOf(*builtin)};
}

} // namespace carina::viewer
