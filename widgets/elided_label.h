#pragma once

#include "widgets/plain_label.h"

namespace carina
{

/// A label of one line, whatever its text and its width are: the end of a text that is too long is
/// left out, and the whole is to be had elsewhere, as from a tooltip. text(), and so what is read
/// aloud, is the whole. An empty one keeps its line, so that nothing beside it moves.
class ElidedLabel : public PlainLabel
{
public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    /// What there is room for.
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace carina
