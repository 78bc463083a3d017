#include "apps/program/options/patient_option.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/anatomy_set.h"
#include "engine/io/anatomy_set/builtin_cache.h"
#include "models/errors/error_text.h"
#include "models/tracker/background_work.h"
#include "ui/import/import_dialog.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

#include <chrono>
#include <cstdio>
#include <optional>

namespace carina::program
{
namespace
{

const QString kAnatomy = QStringLiteral("anatomy");
const QString kPatient = QStringLiteral("patient");
constexpr std::chrono::milliseconds kLongWait{700}; ///< until that is told

/// Whom `--patient` means; without it a child, or an adult for an imported set.
Result<PatientParameters> figuresOf(const QCommandLineParser& parser, bool imported)
{
    if (!parser.isSet(kPatient))
        return parametersOf(imported ? BuiltinPatient::Adult : BuiltinPatient::TwelveYears);
    const auto figures = patientFromWords(parser.value(kPatient).toStdString());
    if (!figures)
        return fail(Errc::WrongOption, "--patient: " + figures.error().detail);
    return figures;
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

/// The built-in patient with these figures, from the cache or made.
Result<SharedPatientModel> builtIn(const PatientParameters& figures)
{
    return cachedPatient(figures, AnatomyCache::defaultFolder()).and_then([](Anatomy&& anatomy) {
        return patientOf(std::move(anatomy));
    });
}

/// The same, while a window tells a person who waits long.
Result<SharedPatientModel> builtInForPerson(const PatientParameters& figures)
{
    QProgressDialog shown{
        QCoreApplication::translate("Program", "The patient is being made. This takes a while, "
                                               "the first time only."),
        QString{}, 0, 0};
    std::optional<Result<SharedPatientModel>> made; // set by the thread that makes it
    BackgroundWork making;
    QEventLoop until;
    QObject::connect(&making, &BackgroundWork::finished, &until, &QEventLoop::quit);
    QTimer::singleShot(kLongWait, &shown, &QWidget::show);
    making.start([&](const Progress& /*goesOn*/) { made = builtIn(figures); });
    until.exec();
    return *std::move(made);
}

} // namespace

void addPatientOptions(QCommandLineParser& parser)
{
    parser.addOption(
        {kAnatomy,
         QCoreApplication::translate("Program", "Show the anatomy set in this folder of surfaces."),
         QStringLiteral("DIR")});
    parser.addOption(
        {kPatient,
         QCoreApplication::translate(
             "Program",
             "Show the built-in patient adult (a man of 30 years) or child (a boy of 12 years; "
             "\"child, girl\" for a girl), or one made from figures, such as \"45 years, 182 cm, "
             "man, obese\". \"adult, airway 250 mm\" sets teeth to carina, as measured on a "
             "manikin. With --anatomy: the patient whose breathing the set gets."),
         QStringLiteral("WHO")});
}

QString patientOption(const QCommandLineParser& parser) { return parser.value(kPatient); }

QString anatomyOption(const QCommandLineParser& parser) { return parser.value(kAnatomy); }

bool importsPatient(const QCommandLineParser& parser) { return parser.isSet(kAnatomy); }

bool namesPatient(const QCommandLineParser& parser)
{
    return importsPatient(parser) || parser.isSet(kPatient);
}

Result<ChosenPatient> choosePatient(const QCommandLineParser& parser)
{
    const bool imported = importsPatient(parser);
    const auto figures = figuresOf(parser, imported);
    if (!figures)
        return tl::unexpected(figures.error());
    const auto dimensions = dimensionsFor(*figures);
    if (!dimensions)
        return tl::unexpected(dimensions.error());
    const bool forPerson = hasPerson(parser);
    auto model =
        imported ? importedPatient(parser.value(kAnatomy).toStdString(), forPerson)
                       .and_then([](Anatomy&& anatomy) { return patientOf(std::move(anatomy)); })
        : forPerson ? builtInForPerson(*figures)
                    : builtIn(*figures);
    if (!model)
        return tl::unexpected(model.error());
    return ChosenPatient{*std::move(model), *dimensions};
}

Result<ChosenPatient> patientForStart(const std::optional<SharedPatientModel>& laid,
                                      const QCommandLineParser& parser)
{
    if (!laid)
        return choosePatient(parser);
    const auto made = parametersOfHash((*laid)->contentHash());
    return dimensionsFor(made.value_or(parametersOf(BuiltinPatient::Adult)))
        .map([&](const PatientDimensions& dimensions) {
            return ChosenPatient{*laid, dimensions};
        });
}

Result<ChosenPatient> importForPerson(const QString& folder)
{
    return importedPatient(folder.toStdString(), true)
        .and_then([](Anatomy&& anatomy) { return patientOf(std::move(anatomy)); })
        .map([](SharedPatientModel model) {
            return ChosenPatient{std::move(model), dimensionsOf(BuiltinPatient::Adult)};
        });
}

} // namespace carina::program
