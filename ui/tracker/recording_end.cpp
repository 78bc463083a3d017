#include "ui/tracker/recording_end.h"

#include "models/errors/error_text.h"
#include "models/text/shown_as_is.h"

#include <QApplication>
#include <QMessageBox>

namespace carina
{
namespace
{

QString endWords(const char* text) { return QApplication::translate("RecordingEnd", text); }

void awaitWriting(PoseRecording& recording)
{
    QMessageBox box;
    box.setObjectName(QStringLiteral("writing"));
    box.setWindowTitle(QApplication::applicationName());
    box.setText(shownAsIs(recording.text()));
    box.setInformativeText(shownAsIs(
        endWords(QT_TRANSLATE_NOOP("RecordingEnd", "The program ends when it is written. "
                                                   "The record in .csv is kept in any case."))));
    box.addButton(endWords(QT_TRANSLATE_NOOP("RecordingEnd", "&Cancel the writing")),
                  QMessageBox::RejectRole);
    QObject::connect(&recording, &PoseRecording::changed, &box, [&] {
        box.setText(shownAsIs(recording.text()));
        if (!recording.isBeingWritten())
            box.accept();
    });
    box.exec();
    recording.cancel(); // where it was not at its end
}

} // namespace

void finishRecording(PoseRecording& recording)
{
    recording.end();
    if (!recording.isBeingWritten())
        return;
    awaitWriting(recording);
    const auto& problem = recording.problem();
    if (recording.isBeingWritten() || !problem || problem->code == Errc::Cancelled)
        return;
    QMessageBox box{QMessageBox::Warning, QApplication::applicationName(),
                    shownAsIs(errorText(*problem)), QMessageBox::Close};
    box.setObjectName(QStringLiteral("unwritten"));
    box.exec();
}

} // namespace carina
