@echo off
rem Drop OpenSim models on this file: it checks their contacts and keeps the window open.
rem Two files are taken as a scaled model and the generic one that was scaled, in either order; a folder as one of scaled models.
set "program=%~dp0osim-contact-scale.exe"
if "%~2"=="" goto each
if not "%~3"=="" goto each
if exist "%~2\" ("%program%" check "%~2" --from "%~1" & goto end)
"%program%" check "%~1" --from "%~2" --format json | findstr /c:"the two are swapped" >nul
if errorlevel 1 ("%program%" check "%~1" --from "%~2") else ("%program%" check "%~2" --from "%~1")
goto end
:each
"%program%" check %*
:end
echo.
pause
