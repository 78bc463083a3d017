#include "apps/program/control_script.h"

#include "engine/io/files/private_file.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QSaveFile>
#include <QScreen>
#include <QTableView>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace carina::program
{
namespace
{

const QString kScript = QStringLiteral("script");
constexpr int kScriptInterval_ms = 200; ///< of the lines: what one opens is there for the next
constexpr double kLongestPause_s = 60.0;
constexpr int kTriesUntilTold = 50; ///< times that a line was tried, until that is told

template <class Control> Control* usable(const QWidget& in, const QString& name)
{
    auto* control = in.findChild<Control*>(name);
    if constexpr (std::is_base_of_v<QWidget, Control>)
        if (control)
            fetched(control); // one in a panel behind others is shut until the panel is in front
    return control && control->isEnabled() ? control : nullptr;
}

bool press(const QWidget& in, const QString& name)
{
    if (auto* button = usable<QAbstractButton>(in, name)) {
        button->click();
        return true;
    }
    auto* action = usable<QAction>(in, name);
    if (action)
        action->trigger();
    return action != nullptr;
}

/// Chooses the entry as a person does, of whom the box tells by a signal of its own.
bool chooseEntry(QComboBox& box, const QString& text)
{
    const int entry = box.findText(text);
    if (entry < 0)
        return false;
    box.setCurrentIndex(entry);
    Q_EMIT box.activated(entry);
    return true;
}

bool choose(const QWidget& in, const QString& name, const QString& text)
{
    if (auto* box = usable<QComboBox>(in, name))
        return chooseEntry(*box, text);
    auto* list = usable<QAbstractItemView>(in, name);
    if (!list || !list->model())
        return false;
    const Qt::MatchFlags how =
        qobject_cast<QTableView*>(list) ? Qt::MatchExactly : Qt::MatchContains;
    const QModelIndexList rows =
        list->model()->match(list->model()->index(0, 0), Qt::DisplayRole, text, 1, how);
    if (rows.isEmpty())
        return false;
    list->setCurrentIndex(rows.first());
    return true;
}

bool type(const QWidget& in, const QString& name, const QString& text)
{
    if (auto* field = usable<QLineEdit>(in, name)) {
        field->setText(text);
        return true;
    }
    auto* box = usable<QAbstractSpinBox>(in, name);
    return box && box->setProperty("value", text.toDouble());
}

bool picture(const QWidget& window, const QString& file)
{
    QSaveFile whole{file}; // never half of it under that name
    // Names of people are in it.
    return whole.open(QIODevice::WriteOnly) && whole.setPermissions(kOwnerOnly)
           && window.screen()->grabWindow(window.winId()).save(&whole, "PNG") && whole.commit();
}

/// Later: a question that it asks is answered by the script.
bool close(QWidget& window)
{
    QTimer::singleShot(0, &window, &QWidget::close);
    return true;
}

/// Milliseconds that a line says to wait; 0 of any other line.
int pauseIn(const QByteArray& line)
{
    const QByteArrayList words = line.trimmed().split(' ');
    if (words.size() != 2 || words[0] != "pause")
        return 0;
    return int(1e3 * std::clamp(words[1].toDouble(), 0.0, kLongestPause_s));
}

} // namespace

ControlScript::ControlScript(Window window, const QString& file)
    : m_window{std::move(window)}, m_file{file}
{
    // What cannot be read, or not again, has no lines.
    if (!m_file.open(QIODevice::ReadWrite) || m_file.isSequential())
        return;
    m_timer.callOnTimeout([this] { goOn(); });
    m_timer.start(kScriptInterval_ms);
}

void ControlScript::goOn()
{
    const qint64 begin = m_file.pos();
    const QByteArray line = m_file.readLine();
    const bool isWhole = line.endsWith('\n'); // the rest may be being written
    m_timer.setInterval(isWhole ? std::max(kScriptInterval_ms, pauseIn(line)) : kScriptInterval_ms);
    if (isWhole && perform(QString::fromUtf8(line).trimmed())) {
        m_waits = 0;
        return;
    }
    m_file.seek(begin);
    if (isWhole && ++m_waits == kTriesUntilTold)
        std::fprintf(stderr, "script: waits for what this needs: %s\n", line.trimmed().constData());
}

bool ControlScript::perform(const QString& line) const
{
    QWidget* dialog = QApplication::activeModalWidget();
    QWidget& in = dialog ? *dialog : m_window();
    if (!in.isVisible())
        return false; // the next one is to come
    const QString verb = line.section(QLatin1Char(' '), 0, 0);
    const QString name = line.section(QLatin1Char(' '), 1, 1);
    const QString text = line.section(QLatin1Char(' '), 2);
    if (verb == QLatin1String{"press"})
        return press(in, name);
    if (verb == QLatin1String{"choose"})
        return choose(in, name, text);
    if (verb == QLatin1String{"picture"})
        return picture(m_window(), line.section(QLatin1Char(' '), 1));
    if (verb == QLatin1String{"close"})
        return close(in);
    if (verb == QLatin1String{"pause"})
        return true;
    return verb == QLatin1String{"type"} && type(in, name, text);
}

void addScriptOption(QCommandLineParser& parser)
{
    parser.addOption({kScript,
                      QCoreApplication::translate(
                          "Program", "Work the controls as the lines of this file say, which may "
                                     "be appended later: press CONTROL, choose LIST ENTRY, type "
                                     "FIELD TEXT, pause SECONDS, close, picture FILE."),
                      QStringLiteral("FILE")});
}

std::unique_ptr<ControlScript> scriptFromOptions(const QCommandLineParser& parser,
                                                 ControlScript::Window window)
{
    return parser.isSet(kScript)
               ? std::make_unique<ControlScript>(std::move(window), parser.value(kScript))
               : nullptr;
}

} // namespace carina::program
