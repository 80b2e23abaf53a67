#include "ui/forms/field_text.h"

#include <QStringList>
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/core/unit_text.h"
#include "sim/core/units.h"
#include "ui/forms/document_model.h"

namespace rotorbench {

using schema::Kind;

namespace {

QString localised(QString number, const QLocale& locale) {
  return number.replace(QLatin1Char('.'), locale.decimalPoint());
}

QString boundText(double si, const QString& unit, const QLocale& locale) {
  return numberInUnit(si, unit, locale);
}

const schema::Option* optionOf(const schema::Field& field, const std::string& key) {
  for (const auto& option : field.options) {
    if (option.key == key) return &option;
  }
  return nullptr;
}

}  // namespace

QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString numberInUnit(double si, const QString& unit, const QLocale& locale) {
  const Unit* shown = findUnit(unit.toStdString());
  std::string digits = shown != nullptr ? numberTextIn(si, shown->factor) : numberText(si);
  const auto exponent = digits.find('e');
  if (exponent != std::string::npos) {
    std::size_t first = exponent + 1;
    if (first < digits.size() && digits[first] == '+') digits.erase(first, 1);
    if (first < digits.size() && digits[first] == '-') ++first;
    while (first + 1 < digits.size() && digits[first] == '0') digits.erase(first, 1);
  }
  return localised(toQString(digits), locale);
}

QString prettyUnit(const QString& symbol) {
  return toQString(prettyUnit(std::string_view(symbol.toStdString())));
}

QString withUnit(const QString& number, const QString& unit) {
  const QString pretty = prettyUnit(unit);
  if (pretty.isEmpty()) return number;
  return pretty == QStringLiteral("°") ? number + pretty : number + QLatin1Char(' ') + pretty;
}

QString valueText(const schema::Field& field, const schema::Value& value, const QString& shownUnit,
                  const QLocale& locale) {
  if (const auto* on = std::get_if<bool>(&value)) {
    return *on ? QStringLiteral("on") : QStringLiteral("off");
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return QString::number(*whole);
  if (const auto* number = std::get_if<double>(&value)) {
    return withUnit(numberInUnit(*number, shownUnit, locale), shownUnit);
  }
  if (const auto* components = std::get_if<std::vector<double>>(&value)) {
    QStringList texts;
    for (const double component : *components) {
      texts += numberInUnit(component, shownUnit, locale);
    }
    const QString separator =
        locale.decimalPoint() == QLatin1String(",") ? QStringLiteral("; ") : QStringLiteral(", ");
    return withUnit(QLatin1Char('(') + texts.join(separator) + QLatin1Char(')'), shownUnit);
  }
  const auto& text = std::get<std::string>(value);
  if (const auto* option = optionOf(field, text)) return toQString(option->label);
  constexpr qsizetype kLongestShown = 40;
  const QString line = toQString(text).simplified();
  const QString shown =
      line.size() > kLongestShown ? line.left(kLongestShown - 1) + QChar(0x2026) : line;
  return QStringLiteral("“%1”").arg(shown);
}

QString rangeText(const schema::Field& field, const QString& shownUnit, const QLocale& locale) {
  if (field.kind == Kind::List) {
    return QStringLiteral("%1 to %2 items").arg(field.minItems).arg(field.maxItems);
  }
  // Integers carry the limits of exact storage, which no person asked about.
  constexpr double kLargestExact = 9007199254740992.0;
  const auto bounded = [&](double v) {
    return std::isfinite(v) && !(field.kind == Kind::Integer && std::abs(v) >= kLargestExact);
  };
  QStringList parts;
  if (bounded(field.range.low.value)) {
    parts += (field.range.low.open ? QStringLiteral("above ") : QStringLiteral("at least ")) +
             boundText(field.range.low.value, shownUnit, locale);
  }
  if (bounded(field.range.high.value)) {
    parts += (field.range.high.open ? QStringLiteral("below ") : QStringLiteral("at most ")) +
             boundText(field.range.high.value, shownUnit, locale);
  }
  if (parts.isEmpty()) return {};
  return withUnit(parts.join(QStringLiteral(" and ")), shownUnit);
}

QString symbolHtml(const QString& symbol) {
  const qsizetype underscore = symbol.indexOf(QLatin1Char('_'));
  const QString base = symbol.left(underscore < 0 ? symbol.size() : underscore);
  QString html = QStringLiteral("<i>%1</i>").arg(base.toHtmlEscaped());
  if (underscore < 0) return html;
  QString subscript = symbol.mid(underscore + 1);
  subscript.remove(QLatin1Char('{')).remove(QLatin1Char('}'));
  return html + QStringLiteral("<sub>%1</sub>").arg(subscript.toHtmlEscaped());
}

QString labelHtml(const schema::Field& field) {
  const QString label = toQString(field.label).toHtmlEscaped();
  if (field.symbol.empty()) return label;
  return label + QStringLiteral("&nbsp; ") + symbolHtml(toQString(field.symbol));
}

QString toolTipHtml(const schema::Field& field, const QString& path, const QString& shownUnit,
                    const QString& defaultText, const QLocale& locale) {
  QString html = QStringLiteral("<b>%1</b>").arg(labelHtml(field));
  const auto line = [&html](const QString& name, const QString& text) {
    if (text.isEmpty()) return;
    html += QStringLiteral("<br><i>%1</i> %2").arg(name, text.toHtmlEscaped());
  };
  if (!field.help.empty()) html += QStringLiteral("<br>") + toQString(field.help).toHtmlEscaped();
  line(QStringLiteral("Range:"), rangeText(field, shownUnit, locale));
  line(QStringLiteral("Default:"), defaultText);
  line(QStringLiteral("Source:"), toQString(field.source));
  line(QStringLiteral("Path:"), path);
  return html;
}

QString componentName(const schema::Field& field, std::size_t index) {
  if (index < field.componentNames.size() && !field.componentNames[index].empty()) {
    return toQString(field.componentNames[index]);
  }
  return QString::number(index + 1);
}

QString elementTitle(const schema::Field& list, const void* owner, std::size_t index) {
  const schema::Type& type = list.childType(owner, index);
  for (const auto& field : type.fields) {
    if (field.kind != Kind::Text) continue;
    if (field.key != "name" && field.key != "title" && field.key != "label") continue;
    const QString name =
        toQString(std::get<std::string>(field.read(list.constChild(owner, index))));
    if (!name.trimmed().isEmpty()) return name.simplified();
  }
  const QString label = toQString(type.label.empty() ? list.label : type.label);
  return QStringLiteral("%1 %2").arg(label).arg(index + 1);
}

QString placeText(schema::ConstRef root, const QString& path) {
  const QString separator = QStringLiteral(" › ");
  QStringList names;
  QString walked;
  const auto step = [&](const QString& key) {
    schema::Location at;
    try {
      at = schema::locate({root.type, const_cast<void*>(root.object)}, key.toStdString());
    } catch (const InputError&) {
      return false;
    }
    if (at.element && at.field->kind != Kind::List) return false;
    names +=
        at.element ? elementTitle(*at.field, at.owner, *at.element) : toQString(at.field->label);
    return true;
  };
  for (const QString& segment : path.split(QLatin1Char('.'), Qt::SkipEmptyParts)) {
    const qsizetype bracket = segment.indexOf(QLatin1Char('['));
    walked = joinPath(walked, bracket < 0 ? segment : segment.left(bracket));
    if (!step(walked)) return names.isEmpty() ? path : names.join(separator);
    if (bracket < 0) continue;
    walked += segment.mid(bracket);
    if (step(walked)) continue;
    // Not a list element, so a component of a vector.
    names.last() += QLatin1Char(' ') + segment.mid(bracket);
    break;
  }
  if (names.isEmpty()) return toQString(root.type->label);
  return names.join(separator);
}

QString asSentence(const QString& text) {
  QString sentence = text.trimmed();
  if (sentence.isEmpty()) return sentence;
  sentence[0] = sentence[0].toUpper();
  const QChar last = sentence.back();
  if (last != QLatin1Char('.') && last != QLatin1Char('?')) sentence += QLatin1Char('.');
  return sentence;
}

QString problemSentence(const Problem& problem) {
  QString sentence = asSentence(toQString(problem.what));
  if (!problem.allowed.empty()) {
    sentence += QLatin1Char(' ') + asSentence(toQString(problem.allowed));
  }
  return sentence;
}

}  // namespace rotorbench
