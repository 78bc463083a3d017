#pragma once

#include "models/scoring/try_watch.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;

namespace carina
{

/// Tells how the last try at intubating went: its outcome in large letters, its main figures, three
/// sentences on what to do next, the points of a rubric with the reason for each that was lost and
/// its moment, figures of the literature beside, and what was not measured. Before it, whether a
/// try is under way, which a button ends. Each part is one text, which has a heading, can be
/// selected, and is read out as a whole. Where the steps of the intubation are listed beside it,
/// points that were lost lead to their moment there.
class TryPanel : public QWidget
{
    Q_OBJECT

public:
    explicit TryPanel(QWidget* parent = nullptr);

    /// To be called once. @pre the model outlives the panel.
    void setModel(TryWatch& tries);
    /// From now on the points that were lost at a moment are links to it.
    void linkMoments();

Q_SIGNALS:
    /// A person asks for the moment at which points were lost.
    void momentAsked(SessionTime moment);

private:
    struct Part {
        QLabel* heading = nullptr;
        QLabel* text = nullptr;
    };

    [[nodiscard]] Part addPart(const char* name, const QString& heading);
    static void tell(const Part& part, const QString& text);
    void refresh();
    void refreshState();
    void showReport(const TryReport& report);
    void askMoment(const QString& link);

    TryWatch* m_tries = nullptr;
    QLabel* m_state;
    QLabel* m_outcome;
    QPushButton* m_finish;
    Part m_figures;
    Part m_advice;
    Part m_points;
    Part m_handling;
    Part m_literature;
    Part m_missing;
    bool m_linksMoments = false;
    QTimer m_clock; ///< while a try is under way
};

} // namespace carina
