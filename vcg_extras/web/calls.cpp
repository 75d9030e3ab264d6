// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of worker.js: a function with JSON as argument and result.
#include "session.h"

#include <vcg_extras/core/parameters.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/options/given_options.h>

#include <deque>
#include <emscripten.h>
#include <functional>
#include <new>

// clang-format off
EM_JS(void, postProgress, (double share, const char* phrase), {
	Module["onProgress"](share, UTF8ToString(phrase));
});
// clang-format on

namespace gpr::web {

namespace {

using app::AppError;
using app::ExitCode;

/// The arrays of the last answer, which never move: short strings lie in the string itself.
std::deque<std::string>& kept()
{
	static std::deque<std::string> arrays;
	return arrays;
}

/// Keeps bytes for the caller, who copies the bytes from the memory of the module.
Json pack(std::string_view bytes)
{
	kept().emplace_back(bytes);
	return {{"at", std::uint32_t(reinterpret_cast<std::uintptr_t>(kept().back().data()))},
			{"length", bytes.size()}};
}

bool tellProgress(double share, const char* phrase)
{
	postProgress(share, phrase);
	return true;
}

Session& session()
{
	static Session one(tellProgress, pack);
	return one;
}

Json rowJson(const Parameter& p)
{
	return {{"key", p.key},
			{"option", p.option},
			{"argument", p.argument},
			{"python", app::pythonName(p, RemeshTool)},
			{"kind", app::kindName(p.kind)},
			{"label", p.label},
			{"help", commandHelp(p)},
			{"minimum", p.minimum},
			{"maximum", p.maximum},
			{"choices", p.choices},
			{"default", app::defaultText(p)},
			{"isSize", isSizeParameter(p)},
			{"isExpert", p.isExpert}};
}

Json table(const Json&)
{
	Json rows = Json::array();
	for (const Parameter& p : remeshParameters())
		if (*p.option != '\0') rows.push_back(rowJson(p));
	return {{"version", GPR_VERSION}, {"parameters", rows}};
}

/// Copies an array of the caller from the memory of the module.
template <class Value, class Array>
void takeArray(const Json& where, Array& values)
{
	const auto* const from =
		reinterpret_cast<const Value*>(std::uintptr_t(where["at"].get<std::uint32_t>()));
	values.assign(from, from + where["length"].get<std::size_t>() / sizeof(Value));
}

Json take(const Json& request)
{
	app::InputMesh mesh;
	mesh.doublePrecision = request["double"];
	if (mesh.doublePrecision)
		takeArray<double>(request["vertices"], mesh.doubles);
	else
		takeArray<float>(request["vertices"], mesh.floats);
	takeArray<std::int32_t>(request["faces"], mesh.triangles);
	return session().take(std::move(mesh));
}

using Call = std::function<Json(const Json&)>;

const std::map<std::string, Call>& calls()
{
	static const std::map<std::string, Call> all = {
		{"table", table},
		{"take", take},
		{"open", [](const Json& r) { return session().open(r["path"]); }},
		{"shownInput", [](const Json&) { return session().shownInput(); }},
		{"estimate", [](const Json& r) { return session().estimate(r["options"]); }},
		{"remesh", [](const Json& r) { return session().remesh(r["options"]); }},
		{"collapse", [](const Json& r) { return session().collapse(r["faces"]); }},
		{"shown", [](const Json& r) { return session().shown(r["key"], r["name"]); }},
		{"measured", [](const Json& r) { return session().measured(r["key"], r["name"]); }},
		{"proven", [](const Json& r) { return session().proven(r["key"]); }},
		{"save", [](const Json& r) { return session().save(r["path"]); }},
		{"arrays", [](const Json&) { return session().arrays(); }},
	};
	return all;
}

Json failure(ExitCode code, const std::string& sentence)
{
	return {{"error", sentence}, {"code", int(code)}};
}

Json answer(const Json& request)
{
	try {
		return calls().at(request["call"])(request);
	}
	catch (const AppError& error) {
		return failure(error.code, error.what());
	}
	catch (const std::bad_alloc&) {
		return failure(ExitCode::Failure, "the browser has no more memory for this.");
	}
	catch (const std::exception& error) {
		return failure(ExitCode::Failure, error.what());
	}
}

} // namespace

extern "C" EMSCRIPTEN_KEEPALIVE const char* gprCall(const char* request)
{
	static std::string text;
	kept().clear();
	text = answer(Json::parse(request)).dump(-1, ' ', false, Json::error_handler_t::replace);
	return text.c_str();
}

} // namespace gpr::web
