#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;

namespace carina
{

/// A line of short statements, the most important first: as many as there is room for, each whole.
/// The tool tip has all of them.
class StatusLine : public QWidget
{
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    void say(const QStringList& statements);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    QLabel* m_label;
    QStringList m_statements;
};

} // namespace carina
