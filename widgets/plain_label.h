#pragma once

#include <QLabel>

namespace carina
{

/// A label that shows its text as it is. A QLabel takes what looks like rich text for that, and
/// loads the pictures it names: names, reasons and texts of files come from others.
class PlainLabel : public QLabel
{
public:
    explicit PlainLabel(QWidget* parent = nullptr) : QLabel{parent}
    {
        setTextFormat(Qt::PlainText);
    }
    explicit PlainLabel(const QString& text, QWidget* parent = nullptr) : PlainLabel{parent}
    {
        setText(text);
    }
};

} // namespace carina
